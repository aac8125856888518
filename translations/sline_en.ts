<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>sline::widgets</name>
    <message numerus="yes">
        <source>%n structures, seen as in the window.</source>
        <translation>
            <numerusform>%n structure, seen as in the window.</numerusform>
            <numerusform>%n structures, seen as in the window.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures as surfaces.</source>
        <translation>
            <numerusform>%n structure as a surface.</numerusform>
            <numerusform>%n structures as surfaces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels as numbers.</source>
        <translation>
            <numerusform>%n label as a number.</numerusform>
            <numerusform>%n labels as numbers.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels as blank lines.</source>
        <translation>
            <numerusform>%n label as a blank line.</numerusform>
            <numerusform>%n labels as blank lines.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels in the scene&apos;s own language.</source>
        <translation>
            <numerusform>%n label in the scene&apos;s own language.</numerusform>
            <numerusform>%n labels in the scene&apos;s own language.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels, language: %1.</source>
        <translation>
            <numerusform>%n label, language: %1.</numerusform>
            <numerusform>%n labels, language: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room: %1.</source>
        <translation>
            <numerusform>%n label found no room: %1.</numerusform>
            <numerusform>%n labels found no room: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are left out, as nothing is drawn there: %1.</source>
        <translation>
            <numerusform>%n label is left out, as nothing is drawn there: %1.</numerusform>
            <numerusform>%n labels are left out, as nothing is drawn there: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels point to places beside the picture: %1.</source>
        <translation>
            <numerusform>%n label points to a place beside the picture: %1.</numerusform>
            <numerusform>%n labels point to places beside the picture: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels have no text in the language and stand in the scene&apos;s own: %1.</source>
        <translation>
            <numerusform>%n label has no text in the language and stands in the scene&apos;s own: %1.</numerusform>
            <numerusform>%n labels have no text in the language and stand in the scene&apos;s own: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room and have no card: %1.</source>
        <translation>
            <numerusform>%n label found no room and has no card: %1.</numerusform>
            <numerusform>%n labels found no room and have no card: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n texts are shortened: %1.</source>
        <translation>
            <numerusform>%n text is shortened: %1.</numerusform>
            <numerusform>%n texts are shortened: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections cut nothing in the file, which holds whole surfaces: %1.</source>
        <translation>
            <numerusform>%n section cuts nothing in the file, which holds whole surfaces: %1.</numerusform>
            <numerusform>%n sections cut nothing in the file, which holds whole surfaces: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels point with a dashed line to what is hidden in this picture: %1.</source>
        <translation>
            <numerusform>%n label points with a dashed line to what is hidden in this picture: %1.</numerusform>
            <numerusform>%n labels point with a dashed line to what is hidden in this picture: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures found no room in the legend: %1.</source>
        <translation>
            <numerusform>%n structure found no room in the legend: %1.</numerusform>
            <numerusform>%n structures found no room in the legend: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures are drawn without noise, which is made of pixels: %1.</source>
        <translation>
            <numerusform>%n structure is drawn without noise, which is made of pixels: %1.</numerusform>
            <numerusform>%n structures are drawn without noise, which is made of pixels: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n slides, one for each saved view.</source>
        <translation>
            <numerusform>%n slide, one for each saved view.</numerusform>
            <numerusform>%n slides, one for each saved view.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files, one for each saved view: %1 … %2.</source>
        <translation>
            <numerusform>%n file, one for each saved view: %1 … %2.</numerusform>
            <numerusform>%n files, one for each saved view: %1 … %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views on about %n pages, with contents, index and bookmarks.</source>
        <translation>
            <numerusform>%1 views on about %n page, with contents, index and bookmarks.</numerusform>
            <numerusform>%1 views on about %n pages, with contents, index and bookmarks.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards, in a deck for each view.</source>
        <translation>
            <numerusform>At most %n card, in a deck for each view.</numerusform>
            <numerusform>At most %n cards, in a deck for each view.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards.</source>
        <translation>
            <numerusform>At most %n card.</numerusform>
            <numerusform>At most %n cards.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n questions with pictures.</source>
        <translation>
            <numerusform>At most %n question with a picture.</numerusform>
            <numerusform>At most %n questions with pictures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as one does not see there what is named: %1.</source>
        <translation>
            <numerusform>%n label is not asked for, as one does not see there what is named: %1.</numerusform>
            <numerusform>%n labels are not asked for, as one does not see there what is named: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 and %n more</source>
        <translation>
            <numerusform>%1: %2 and %n more</numerusform>
            <numerusform>%1: %2 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n patients. Put them into one scene?</source>
        <translation>
            <numerusform>These files are of %n patient. Put them into one scene?</numerusform>
            <numerusform>These files are of %n patients. Put them into one scene?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n studies, and nothing says that they are of one patient. Put them into one scene?</source>
        <translation>
            <numerusform>These files are of %n study, and nothing says that they are of one patient. Put them into one scene?</numerusform>
            <numerusform>These files are of %n studies, and nothing says that they are of one patient. Put them into one scene?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Something in it is at fault and was left out: %1; and %n more</source>
        <translation>
            <numerusform>Something in it is at fault and was left out: %1; and %n more</numerusform>
            <numerusform>Something in it is at fault and was left out: %1; and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels stand on anatomy, which leaves no room beside it: %1.</source>
        <translation>
            <numerusform>%n label stands on anatomy, which leaves no room beside it: %1.</numerusform>
            <numerusform>%n labels stand on anatomy, which leaves no room beside it: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Names tell that these files are of %n bodies. Put them into one scene?</source>
        <translation>
            <numerusform>Names tell that these files are of %n body. Put them into one scene?</numerusform>
            <numerusform>Names tell that these files are of %n bodies. Put them into one scene?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as what they name may lie on the other side: %1.</source>
        <translation>
            <numerusform>%n label is not asked for, as what it names may lie on the other side: %1.</numerusform>
            <numerusform>%n labels are not asked for, as what they name may lie on the other side: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushBar</name>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n structure</numerusform>
            <numerusform>%n structures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportActions</name>
    <message numerus="yes">
        <source>Exporting %n files</source>
        <translation>
            <numerusform>Exporting %n file</numerusform>
            <numerusform>Exporting %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>Exported %n file</numerusform>
            <numerusform>Exported %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportDialog</name>
    <message numerus="yes">
        <source>Each sa&amp;ved view, %n files</source>
        <translation>
            <numerusform>Each sa&amp;ved view, %n file</numerusform>
            <numerusform>Each sa&amp;ved view, %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of the files are there already. Replace them?</source>
        <translation>
            <numerusform>%n of the files is there already. Replace it?</numerusform>
            <numerusform>%n of the files are there already. Replace them?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n sa&amp;ved views, in one file</source>
        <translation>
            <numerusform>The %n sa&amp;ved view, in one file</numerusform>
            <numerusform>All %n sa&amp;ved views, in one file</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusPanel</name>
    <message numerus="yes">
        <source>%n structures in focus</source>
        <translation>
            <numerusform>%n structure in focus</numerusform>
            <numerusform>%n structures in focus</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Also %n hidden structures</source>
        <translation>
            <numerusform>Also %n hidden structure</numerusform>
            <numerusform>Also %n hidden structures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n by Hand: Back to the Focus</source>
        <translation>
            <numerusform>%n by Hand: Back to the Focus</numerusform>
            <numerusform>%n by Hand: Back to the Focus</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaMapEditor</name>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n item</numerusform>
            <numerusform>%n items</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaPanel</name>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n item</numerusform>
            <numerusform>%n items</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportActions</name>
    <message numerus="yes">
        <source>%n structures were read as %1, unlike alone: so they go with the open scene</source>
        <translation>
            <numerusform>%n structure was read as %1, unlike alone: so it goes with the open scene</numerusform>
            <numerusform>%n structures were read as %1, unlike alone: so they go with the open scene</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDraft</name>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>; and %n more</numerusform>
            <numerusform>; and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n structure</numerusform>
            <numerusform>%n structures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n groups</source>
        <translation>
            <numerusform>%n group</numerusform>
            <numerusform>%n groups</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n skipped</numerusform>
            <numerusform>%n skipped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures lie on the other side than their names say: %1.</source>
        <translation>
            <numerusform>%n structure lies on the other side than its name says: %1.</numerusform>
            <numerusform>%n structures lie on the other side than their names say: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces mended</source>
        <translation>
            <numerusform>%n face mended</numerusform>
            <numerusform>%n faces mended</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left and right look swapped: all %n structures with a side in their names lie on the other side (%1).</source>
        <translation>
            <numerusform>Left and right look swapped: the %n structure with a side in its name lies on the other side (%1).</numerusform>
            <numerusform>Left and right look swapped: all %n structures with a side in their names lie on the other side (%1).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelActions</name>
    <message numerus="yes">
        <source>Add %n labels</source>
        <translation>
            <numerusform>Add %n label</numerusform>
            <numerusform>Add %n labels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels added</source>
        <translation>
            <numerusform>%n label added</numerusform>
            <numerusform>%n labels added</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n have no room in this picture: the panel Labels says which</source>
        <translation>
            <numerusform>%n has no room in this picture: the panel Labels says which</numerusform>
            <numerusform>%n have no room in this picture: the panel Labels says which</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelViews</name>
    <message numerus="yes">
        <source>In %n views</source>
        <translation>
            <numerusform>In %n view</numerusform>
            <numerusform>In %n views</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::LongestText</name>
    <message numerus="yes">
        <source>At most %n characters have room here</source>
        <translation>
            <numerusform>At most %n character has room here</numerusform>
            <numerusform>At most %n characters have room here</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::MessageBar</name>
    <message numerus="yes">
        <source>Show all %n</source>
        <translation>
            <numerusform>Show %n</numerusform>
            <numerusform>Show all %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureMenu</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::PocketsPanel</name>
    <message numerus="yes">
        <source>%n residues at its wall: %1</source>
        <translation>
            <numerusform>%n residue at its wall: %1</numerusform>
            <numerusform>%n residues at its wall: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pockets</source>
        <translation>
            <numerusform>%n pocket</numerusform>
            <numerusform>%n pockets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::PrintProofDialog</name>
    <message numerus="yes">
        <source>%n pairs of neighbours look alike in print or to some eyes.</source>
        <translation>
            <numerusform>%n pair of neighbours looks alike in print or to some eyes.</numerusform>
            <numerusform>%n pairs of neighbours look alike in print or to some eyes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n of them no change was found.</source>
        <translation>
            <numerusform>For %n of them no change was found.</numerusform>
            <numerusform>For %n of them no change was found.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::SelectionPanel</name>
    <message numerus="yes">
        <source>For the selected %n structures</source>
        <translation>
            <numerusform>For the selected structure</numerusform>
            <numerusform>For the selected %n structures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read again</source>
        <translation>
            <numerusform>%n structure was read again</numerusform>
            <numerusform>%n structures were read again</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n items</source>
        <translation>
            <numerusform>%1 of %n item</numerusform>
            <numerusform>%1 of %n items</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTree</name>
    <message numerus="yes">
        <source>%n structures – Enter selects them</source>
        <translation>
            <numerusform>%n structure – Enter selects it</numerusform>
            <numerusform>%n structures – Enter selects them</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewList</name>
    <message numerus="yes">
        <source>%n of the structures and labels it shows are no longer in the scene</source>
        <translation>
            <numerusform>%n of the structures and labels it shows is no longer in the scene</numerusform>
            <numerusform>%n of the structures and labels it shows are no longer in the scene</numerusform>
        </translation>
    </message>
</context>
</TS>
