<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>main</name>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations.</source>
        <translation>Macht aus segmentierter Anatomie Linienillustrationen mit Fokus und Kontext.</translation>
    </message>
    <message>
        <source>Meshes, label volumes, DICOM segmentations, molecules, folders of them, 3D Slicer scenes, scene files.</source>
        <translation>Netze, Labelvolumen, DICOM-Segmentierungen, Moleküle, Ordner davon, 3D-Slicer-Szenen, Szenendateien.</translation>
    </message>
</context>
<context>
    <name>sline::widgets</name>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>The outer edge alone</source>
        <translation>Nur der äußere Rand</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Every edge that faces away</source>
        <translation>Jede Kante, die sich abwendet</translation>
    </message>
    <message>
        <source>Suggestive contours</source>
        <translation>Suggestive Konturen</translation>
    </message>
    <message>
        <source>Lines along folds as well</source>
        <translation>Auch Linien entlang von Falten</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Schraffur</translation>
    </message>
    <message>
        <source>Tone by strokes</source>
        <translation>Tonwerte durch Striche</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Colour behind lines and strokes</source>
        <translation>Farbe hinter Linien und Strichen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>The shaded surface alone</source>
        <translation>Nur die schattierte Oberfläche</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Erscheinungsbild</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Light or dark controls; the picture has a background of its own</source>
        <translation>Helle oder dunkle Bedienelemente; das Bild hat einen eigenen Hintergrund</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Text under the toolbar’s icons</source>
        <translation>Text unter den Symbolen der Werkzeugleiste</translation>
    </message>
    <message>
        <source>What each button does in a word</source>
        <translation>Was jede Schaltfläche tut, in einem Wort</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>What the picture is drawn on; on the dark one ink is light</source>
        <translation>Worauf das Bild gezeichnet wird; auf dunklem Grund ist die Tinte hell</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Pelvis of a Woman</source>
        <translation>Becken einer Frau</translation>
    </message>
    <message>
        <source>Pelvis of a Man</source>
        <translation>Becken eines Mannes</translation>
    </message>
    <message>
        <source>Abdomen of a Woman</source>
        <translation>Bauch einer Frau</translation>
    </message>
    <message>
        <source>Abdomen of a Man</source>
        <translation>Bauch eines Mannes</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Niere</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>De&amp;mo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Structure</source>
        <translation>&amp;Struktur</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>&amp;Gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>S&amp;chnitt</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>&amp;Open Files…</source>
        <translation>Dateien ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open mesh files or a 3D Slicer scene</source>
        <translation>Netzdateien oder eine 3D-Slicer-Szene öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Folder…</source>
        <translation>&amp;Ordner öffnen …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open all meshes in a folder</source>
        <translation>Alle Netze in einem Ordner öffnen</translation>
    </message>
    <message>
        <source>&amp;Reload from Source</source>
        <translation>Von der Quelle &amp;neu laden</translation>
    </message>
    <message>
        <source>Read meshes again whose files have changed</source>
        <translation>Netze erneut lesen, deren Dateien sich geändert haben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Das Programm beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last step back</source>
        <translation>Den letzten Schritt zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Den Schritt noch einmal tun</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Theme, background and other habits</source>
        <translation>Farbschema, Hintergrund und andere Gewohnheiten</translation>
    </message>
    <message>
        <source>&amp;Find Structure</source>
        <translation>Struktur &amp;suchen</translation>
    </message>
    <message>
        <source>Type a few letters of a name</source>
        <translation>Einige Buchstaben eines Namens tippen</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Fokus</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>The selected structures in detail, everything else as contours</source>
        <translation>Die gewählten Strukturen in allen Einzelheiten, alles andere als Konturen</translation>
    </message>
    <message>
        <source>&amp;Context</source>
        <translation>&amp;Kontext</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>The selected structures as contours</source>
        <translation>Die gewählten Strukturen als Konturen</translation>
    </message>
    <message>
        <source>&amp;Inherit Γ</source>
        <translation>Γ er&amp;ben</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Γ wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Show or &amp;Hide</source>
        <translation>Ein- oder aus&amp;blenden</translation>
    </message>
    <message>
        <source>Hide the selected structures, or show them again (Space in the list)</source>
        <translation>Die gewählten Strukturen ausblenden oder wieder zeigen (Leertaste in der Liste)</translation>
    </message>
    <message>
        <source>I&amp;solate</source>
        <translation>&amp;Isolieren</translation>
    </message>
    <message>
        <source>/</source>
        <translation>/</translation>
    </message>
    <message>
        <source>Hide everything else</source>
        <translation>Alles andere ausblenden</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>&amp;Alle zeigen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Hide nothing</source>
        <translation>Nichts ausblenden</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene</source>
        <translation>Die gewählten Strukturen aus der Szene nehmen</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Seen from the front</source>
        <translation>Von vorn gesehen</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Seen from the back</source>
        <translation>Von hinten gesehen</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s left</source>
        <translation>Von der linken Seite des Patienten gesehen</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Von &amp;rechts</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s right</source>
        <translation>Von der rechten Seite des Patienten gesehen</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Seen from above</source>
        <translation>Von oben gesehen</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>Von &amp;unten</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Seen from below</source>
        <translation>Von unten gesehen</translation>
    </message>
    <message>
        <source>&amp;Fit All</source>
        <translation>Alles &amp;einpassen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Bring all that is shown into the picture</source>
        <translation>Alles Gezeigte ins Bild bringen</translation>
    </message>
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittal</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Cut in the plane between left and right; again: whole</source>
        <translation>In der Ebene zwischen links und rechts schneiden; noch einmal: ganz</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Koronal</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Cut in the plane between front and back; again: whole</source>
        <translation>In der Ebene zwischen vorn und hinten schneiden; noch einmal: ganz</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Axial</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Cut in the plane between upper and lower; again: whole</source>
        <translation>In der Ebene zwischen oben und unten schneiden; noch einmal: ganz</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Umdrehen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Keep the other side of each section</source>
        <translation>Von jedem Schnitt die andere Seite behalten</translation>
    </message>
    <message>
        <source>&amp;Whole Again</source>
        <translation>&amp;Wieder ganz</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Take all sections away</source>
        <translation>Alle Schnitte wegnehmen</translation>
    </message>
    <message>
        <source>&amp;Key Light</source>
        <translation>Hauptl&amp;icht</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Light from the upper left on what is shaded</source>
        <translation>Licht von links oben auf alles Schattierte</translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Was Maus und Tasten tun</translation>
    </message>
    <message>
        <source>&amp;About Sline</source>
        <translation>&amp;Über Sline</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Was dieses Programm ist</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Ziehen mit links</translation>
    </message>
    <message>
        <source>Turn around the pivot</source>
        <translation>Um den Drehpunkt drehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag</source>
        <translation>Ziehen mit der Mitteltaste, Umschalt + Ziehen mit links</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Das Bild verschieben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Zoom to the mouse</source>
        <translation>Zur Maus hin zoomen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Select what is seen there; Ctrl adds to the selection</source>
        <translation>Wählen, was dort zu sehen ist; Strg fügt zur Auswahl hinzu</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Turn around this place from now on</source>
        <translation>Von nun an um diese Stelle drehen</translation>
    </message>
    <message>
        <source>Space in the list</source>
        <translation>Leertaste in der Liste</translation>
    </message>
    <message>
        <source>Show or hide the selected structures</source>
        <translation>Die gewählten Strukturen zeigen oder ausblenden</translation>
    </message>
    <message>
        <source>Escape during a drag</source>
        <translation>Esc während des Ziehens</translation>
    </message>
    <message>
        <source>As it was before</source>
        <translation>Wie es vorher war</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Bedienoberfläche</translation>
    </message>
    <message>
        <source>The language of menus and texts; takes effect at once</source>
        <translation>Die Sprache von Menüs und Texten; gilt sofort</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>What known structures are called on screen; files keep their own names</source>
        <translation>Wie bekannte Strukturen am Bildschirm heißen; Dateien behalten ihre eigenen Namen</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>In the interface’s language</source>
        <translation>In der Sprache der Bedienoberfläche</translation>
    </message>
    <message>
        <source>Latin</source>
        <translation>Latein</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>Dutch</source>
        <translation>Niederländisch</translation>
    </message>
    <message>
        <source>Norwegian</source>
        <translation>Norwegisch</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AboutDialog</name>
    <message>
        <source>About Sline</source>
        <translation>Über Sline</translation>
    </message>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations. Free software under the Apache License 2.0.</source>
        <translation>Macht aus segmentierter Anatomie Linienillustrationen mit Fokus und Kontext. Freie Software unter der Apache-Lizenz 2.0.</translation>
    </message>
    <message>
        <source>After Lichtenberg, Smit, Hansen and Lawonn, “Sline: Seamless Line Illustration for Interactive Biomedical Visualization” (VCBM 2016), and Lawonn, Mönch and Preim, “Streamlines for Illustrative Real-Time Rendering” (EuroVis 2013).</source>
        <translation>Nach Lichtenberg, Smit, Hansen und Lawonn, „Sline: Seamless Line Illustration for Interactive Biomedical Visualization“ (VCBM 2016), und Lawonn, Mönch und Preim, „Streamlines for Illustrative Real-Time Rendering“ (EuroVis 2013).</translation>
    </message>
    <message>
        <source>Qt %1 on %2
OpenGL: %3</source>
        <translation>Qt %1 auf %2
OpenGL: %3</translation>
    </message>
    <message>
        <source>not started yet</source>
        <translation>noch nicht gestartet</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ControlsDialog</name>
    <message>
        <source>Mouse and Keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaPanel</name>
    <message>
        <source>Nothing selected</source>
        <translation>Nichts ausgewählt</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n Element</numerusform>
            <numerusform>%n Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Wähle eine Struktur in der Liste oder im Bild.</translation>
    </message>
    <message>
        <source>Gamma, from silhouette to surface</source>
        <translation>Gamma, von der Silhouette zur Oberfläche</translation>
    </message>
    <message>
        <source>Gamma as a number</source>
        <translation>Gamma als Zahl</translation>
    </message>
    <message>
        <source>Γ  </source>
        <translation>Γ  </translation>
    </message>
    <message>
        <source>Inherit</source>
        <translation>Erben</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Γ wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>What is behind shows through</source>
        <translation>Was dahinter liegt, scheint durch</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Deckend</translation>
    </message>
    <message>
        <source>Hides what is behind</source>
        <translation>Verdeckt, was dahinter liegt</translation>
    </message>
    <message>
        <source>Veil</source>
        <translation>Schleier</translation>
    </message>
    <message>
        <source>What is behind shows faintly, as through tracing paper</source>
        <translation>Was dahinter liegt, scheint schwach durch wie durch Pauspapier</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>A thin wash of the structure&apos;s colour; what is behind shows through</source>
        <translation>Eine dünne Lasur in der Farbe der Struktur; was dahinter liegt, scheint durch</translation>
    </message>
    <message>
        <source>Where only lines are drawn</source>
        <translation>Wo nur Linien gezeichnet sind</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>Hervorhebung</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>These in detail, everything else as contours</source>
        <translation>Diese in allen Einzelheiten, alles andere als Konturen</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
    <message>
        <source>These as contours</source>
        <translation>Diese als Konturen</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ erben</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
</context>
<context>
    <name>sline::widgets::MainWindow</name>
    <message>
        <source>Structures: %1   Triangles: %2</source>
        <translation>Strukturen: %1   Dreiecke: %2</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Line Style</source>
        <translation>Linienstil</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ erben</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Turning around this place on %1</source>
        <translation>Dreht um diese Stelle an %1</translation>
    </message>
    <message>
        <source>Open Files</source>
        <translation>Dateien öffnen</translation>
    </message>
    <message>
        <source>Meshes and scenes (%1);;All files (*)</source>
        <translation>Netze und Szenen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open Folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>%1 – Sline</source>
        <translation>%1 – Sline</translation>
    </message>
</context>
<context>
    <name>sline::widgets::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Die Meldung schließen</translation>
    </message>
    <message>
        <source>Opened, with remarks</source>
        <translation>Geöffnet, mit Anmerkungen</translation>
    </message>
    <message numerus="yes">
        <source>Show all %n</source>
        <translation>
            <numerusform>%n zeigen</numerusform>
            <numerusform>Alle %n zeigen</numerusform>
        </translation>
    </message>
    <message>
        <source>What was left out or mended</source>
        <translation>Was weggelassen oder ausgebessert wurde</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionActions</name>
    <message>
        <source>%1 Section</source>
        <translation>Schnitt: %1</translation>
    </message>
    <message>
        <source>Without %1 Section</source>
        <translation>Ohne Schnitt: %1</translation>
    </message>
    <message>
        <source>Flip Sections</source>
        <translation>Schnitte umdrehen</translation>
    </message>
    <message>
        <source>Whole Again</source>
        <translation>Wieder ganz</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
    <message>
        <source>Γ of %1</source>
        <translation>Γ von %1</translation>
    </message>
    <message numerus="yes">
        <source>Γ of %n items</source>
        <translation>
            <numerusform>Γ von %n Element</numerusform>
            <numerusform>Γ von %n Elementen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>No file that could be read again has changed</source>
        <translation>Keine Datei, die erneut gelesen werden kann, hat sich geändert</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read again</source>
        <translation>
            <numerusform>%n Struktur wurde erneut gelesen</numerusform>
            <numerusform>%n Strukturen wurden erneut gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from source</source>
        <translation>Von der Quelle neu laden</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTree</name>
    <message>
        <source>Filter structures by name</source>
        <translation>Strukturen nach Namen filtern</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeModel</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Partly shown</source>
        <translation>Teilweise gezeigt</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>%1, from the group above</source>
        <translation>%1, von der Gruppe darüber</translation>
    </message>
    <message>
        <source>%1, structures: %2</source>
        <translation>%1, Strukturen: %2</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Γ</source>
        <translation>Γ</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeView</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewActions</name>
    <message>
        <source>Key Light</source>
        <translation>Hauptlicht</translation>
    </message>
    <message>
        <source>View “%1”</source>
        <translation>Ansicht „%1“</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
</context>
</TS>
