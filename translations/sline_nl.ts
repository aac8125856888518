<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>main</name>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations.</source>
        <translation>Maakt van gesegmenteerde anatomie lijnillustraties met focus en context.</translation>
    </message>
    <message>
        <source>Meshes, label volumes, DICOM segmentations, molecules, folders of them, 3D Slicer scenes, scene files.</source>
        <translation>Meshes, labelvolumes, DICOM-segmentaties, moleculen, mappen daarvan, 3D Slicer-scènes, scènebestanden.</translation>
    </message>
</context>
<context>
    <name>sline::widgets</name>
    <message>
        <source>Silhouette</source>
        <translation>Silhouet</translation>
    </message>
    <message>
        <source>The outer edge alone</source>
        <translation>Alleen de buitenrand</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Contouren</translation>
    </message>
    <message>
        <source>Every edge that faces away</source>
        <translation>Elke rand die zich afwendt</translation>
    </message>
    <message>
        <source>Suggestive contours</source>
        <translation>Suggestieve contouren</translation>
    </message>
    <message>
        <source>Lines along folds as well</source>
        <translation>Ook lijnen langs plooien</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Arcering</translation>
    </message>
    <message>
        <source>Tone by strokes</source>
        <translation>Toon door streken</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schaduw</translation>
    </message>
    <message>
        <source>Colour behind lines and strokes</source>
        <translation>Kleur achter lijnen en streken</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oppervlak</translation>
    </message>
    <message>
        <source>The shaded surface alone</source>
        <translation>Alleen het oppervlak met schaduw</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Uiterlijk</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Light or dark controls; the picture has a background of its own</source>
        <translation>Lichte of donkere bediening; het beeld heeft een eigen achtergrond</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Zoals het systeem</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>Text under the toolbar’s icons</source>
        <translation>Tekst onder de pictogrammen van de werkbalk</translation>
    </message>
    <message>
        <source>What each button does in a word</source>
        <translation>Wat elke knop doet, in één woord</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Beeld</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Achtergrond</translation>
    </message>
    <message>
        <source>What the picture is drawn on; on the dark one ink is light</source>
        <translation>Waarop het beeld getekend wordt; op donker is de inkt licht</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Wit</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Pelvis of a Woman</source>
        <translation>Bekken van een vrouw</translation>
    </message>
    <message>
        <source>Pelvis of a Man</source>
        <translation>Bekken van een man</translation>
    </message>
    <message>
        <source>Abdomen of a Woman</source>
        <translation>Buik van een vrouw</translation>
    </message>
    <message>
        <source>Abdomen of a Man</source>
        <translation>Buik van een man</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Nier</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Bestand</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>De&amp;mo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Be&amp;werken</translation>
    </message>
    <message>
        <source>&amp;Structure</source>
        <translation>&amp;Structuur</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Beel&amp;d</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>Op&amp;geslagen aanzichten</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>&amp;Doorsnede</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Achtergrond</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pa&amp;nelen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Help</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Werkbalk</translation>
    </message>
    <message>
        <source>&amp;Open Files…</source>
        <translation>Bestanden &amp;openen…</translation>
    </message>
    <message>
        <source>Open mesh files or a 3D Slicer scene</source>
        <translation>Meshbestanden of een 3D Slicer-scène openen</translation>
    </message>
    <message>
        <source>Open &amp;Folder…</source>
        <translation>&amp;Map openen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open all meshes in a folder</source>
        <translation>Alle meshes in een map openen</translation>
    </message>
    <message>
        <source>&amp;Reload from Source</source>
        <translation>&amp;Opnieuw laden van de bron</translation>
    </message>
    <message>
        <source>Read meshes again whose files have changed</source>
        <translation>Meshes opnieuw lezen waarvan het bestand is gewijzigd</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Afsluiten</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Het programma sluiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ongedaan maken</translation>
    </message>
    <message>
        <source>Take the last step back</source>
        <translation>De laatste stap terugnemen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Opn&amp;ieuw</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>De stap opnieuw doen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Voorkeuren…</translation>
    </message>
    <message>
        <source>Theme, background and other habits</source>
        <translation>Thema, achtergrond en andere gewoonten</translation>
    </message>
    <message>
        <source>&amp;Find Structure</source>
        <translation>Structuur &amp;zoeken</translation>
    </message>
    <message>
        <source>Type a few letters of a name</source>
        <translation>Typ een paar letters van een naam</translation>
    </message>
    <message>
        <source>&amp;Focus</source>
        <translation>&amp;Focus</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>The selected structures in detail, everything else as contours</source>
        <translation>De gekozen structuren in detail, al het andere als contouren</translation>
    </message>
    <message>
        <source>&amp;Context</source>
        <translation>&amp;Context</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>The selected structures as contours</source>
        <translation>De gekozen structuren als contouren</translation>
    </message>
    <message>
        <source>&amp;Inherit Γ</source>
        <translation>Γ over&amp;nemen</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Γ weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Show or &amp;Hide</source>
        <translation>Tonen of &amp;verbergen</translation>
    </message>
    <message>
        <source>Hide the selected structures, or show them again (Space in the list)</source>
        <translation>De gekozen structuren verbergen of weer tonen (spatie in de lijst)</translation>
    </message>
    <message>
        <source>I&amp;solate</source>
        <translation>I&amp;soleren</translation>
    </message>
    <message>
        <source>/</source>
        <translation>/</translation>
    </message>
    <message>
        <source>Hide everything else</source>
        <translation>Al het andere verbergen</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>&amp;Alles tonen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Hide nothing</source>
        <translation>Niets verbergen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ver&amp;wijderen</translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene</source>
        <translation>De gekozen structuren uit de scène halen</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>Van &amp;voren</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Seen from the front</source>
        <translation>Van voren gezien</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>Van &amp;achteren</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Seen from the back</source>
        <translation>Van achteren gezien</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Van &amp;links</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s left</source>
        <translation>Vanaf de linkerkant van de patiënt gezien</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Van &amp;rechts</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s right</source>
        <translation>Vanaf de rechterkant van de patiënt gezien</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>Van &amp;boven</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Seen from above</source>
        <translation>Van boven gezien</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>Van &amp;onderen</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Seen from below</source>
        <translation>Van onderen gezien</translation>
    </message>
    <message>
        <source>&amp;Fit All</source>
        <translation>Alles &amp;passend</translation>
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
        <translation>Alles wat getoond wordt in beeld brengen</translation>
    </message>
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittaal</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Cut in the plane between left and right; again: whole</source>
        <translation>Snijden in het vlak tussen links en rechts; nogmaals: heel</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Coronaal</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Cut in the plane between front and back; again: whole</source>
        <translation>Snijden in het vlak tussen voor en achter; nogmaals: heel</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Axiaal</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Cut in the plane between upper and lower; again: whole</source>
        <translation>Snijden in het vlak tussen boven en onder; nogmaals: heel</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Omkeren</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Keep the other side of each section</source>
        <translation>Van elke doorsnede de andere kant houden</translation>
    </message>
    <message>
        <source>&amp;Whole Again</source>
        <translation>&amp;Weer heel</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Take all sections away</source>
        <translation>Alle doorsneden weghalen</translation>
    </message>
    <message>
        <source>&amp;Key Light</source>
        <translation>&amp;Hoofdlicht</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Light from the upper left on what is shaded</source>
        <translation>Licht van linksboven op alles met schaduw</translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation>&amp;Muis en toetsen</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Wat de muis en de toetsen doen</translation>
    </message>
    <message>
        <source>&amp;About Sline</source>
        <translation>&amp;Over Sline</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Wat dit programma is</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Slepen met links</translation>
    </message>
    <message>
        <source>Turn around the pivot</source>
        <translation>Om het draaipunt draaien</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag</source>
        <translation>Slepen met de middelste knop, Shift + slepen met links</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Het beeld verschuiven</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Wiel</translation>
    </message>
    <message>
        <source>Zoom to the mouse</source>
        <translation>Naar de muis zoomen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klik</translation>
    </message>
    <message>
        <source>Select what is seen there; Ctrl adds to the selection</source>
        <translation>Kies wat daar te zien is; Ctrl voegt toe aan de selectie</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Dubbelklik</translation>
    </message>
    <message>
        <source>Turn around this place from now on</source>
        <translation>Voortaan om deze plek draaien</translation>
    </message>
    <message>
        <source>Space in the list</source>
        <translation>Spatie in de lijst</translation>
    </message>
    <message>
        <source>Show or hide the selected structures</source>
        <translation>De gekozen structuren tonen of verbergen</translation>
    </message>
    <message>
        <source>Escape during a drag</source>
        <translation>Esc tijdens het slepen</translation>
    </message>
    <message>
        <source>As it was before</source>
        <translation>Zoals het was</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Interface</translation>
    </message>
    <message>
        <source>The language of menus and texts; takes effect at once</source>
        <translation>De taal van menu’s en teksten; geldt meteen</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structuren</translation>
    </message>
    <message>
        <source>What known structures are called on screen; files keep their own names</source>
        <translation>Hoe bekende structuren op het scherm heten; bestanden houden hun eigen namen</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Zoals in het bestand</translation>
    </message>
    <message>
        <source>In the interface’s language</source>
        <translation>In de taal van de interface</translation>
    </message>
    <message>
        <source>Latin</source>
        <translation>Latijn</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Engels</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Duits</translation>
    </message>
    <message>
        <source>Dutch</source>
        <translation>Nederlands</translation>
    </message>
    <message>
        <source>Norwegian</source>
        <translation>Noors</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AboutDialog</name>
    <message>
        <source>About Sline</source>
        <translation>Over Sline</translation>
    </message>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations. Free software under the Apache License 2.0.</source>
        <translation>Maakt van gesegmenteerde anatomie lijnillustraties met focus en context. Vrije software onder de Apache-licentie 2.0.</translation>
    </message>
    <message>
        <source>After Lichtenberg, Smit, Hansen and Lawonn, “Sline: Seamless Line Illustration for Interactive Biomedical Visualization” (VCBM 2016), and Lawonn, Mönch and Preim, “Streamlines for Illustrative Real-Time Rendering” (EuroVis 2013).</source>
        <translation>Naar Lichtenberg, Smit, Hansen en Lawonn, “Sline: Seamless Line Illustration for Interactive Biomedical Visualization” (VCBM 2016), en Lawonn, Mönch en Preim, “Streamlines for Illustrative Real-Time Rendering” (EuroVis 2013).</translation>
    </message>
    <message>
        <source>Qt %1 on %2
OpenGL: %3</source>
        <translation>Qt %1 op %2
OpenGL: %3</translation>
    </message>
    <message>
        <source>not started yet</source>
        <translation>nog niet gestart</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiëren</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ControlsDialog</name>
    <message>
        <source>Mouse and Keys</source>
        <translation>Muis en toetsen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filteren</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Muis</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaPanel</name>
    <message>
        <source>Nothing selected</source>
        <translation>Niets gekozen</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Kies een structuur in de lijst of in het beeld.</translation>
    </message>
    <message>
        <source>Gamma, from silhouette to surface</source>
        <translation>Gamma, van silhouet tot oppervlak</translation>
    </message>
    <message>
        <source>Gamma as a number</source>
        <translation>Gamma als getal</translation>
    </message>
    <message>
        <source>Γ  </source>
        <translation>Γ  </translation>
    </message>
    <message>
        <source>Inherit</source>
        <translation>Overnemen</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Γ weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>What is behind shows through</source>
        <translation>Wat erachter ligt schijnt door</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Dekkend</translation>
    </message>
    <message>
        <source>Hides what is behind</source>
        <translation>Bedekt wat erachter ligt</translation>
    </message>
    <message>
        <source>Veil</source>
        <translation>Sluier</translation>
    </message>
    <message>
        <source>What is behind shows faintly, as through tracing paper</source>
        <translation>Wat erachter ligt schijnt vaag door, als door calqueerpapier</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tint</translation>
    </message>
    <message>
        <source>A thin wash of the structure&apos;s colour; what is behind shows through</source>
        <translation>Een dunne laag in de kleur van de structuur; wat erachter ligt schijnt door</translation>
    </message>
    <message>
        <source>Where only lines are drawn</source>
        <translation>Waar alleen lijnen getekend zijn</translation>
    </message>
    <message>
        <source>Emphasis</source>
        <translation>Nadruk</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>These in detail, everything else as contours</source>
        <translation>Deze in detail, al het andere als contouren</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Context</translation>
    </message>
    <message>
        <source>These as contours</source>
        <translation>Deze als contouren</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ overnemen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vulling</translation>
    </message>
</context>
<context>
    <name>sline::widgets::MainWindow</name>
    <message>
        <source>Structures: %1   Triangles: %2</source>
        <translation>Structuren: %1   Driehoeken: %2</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structuren</translation>
    </message>
    <message>
        <source>Line Style</source>
        <translation>Lijnstijl</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Geschiedenis</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Zoals geopend</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Voortgang</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 openen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ongedaan maken</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Opn&amp;ieuw</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Context</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ overnemen</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoleren</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Turning around this place on %1</source>
        <translation>Draait om deze plek op %1</translation>
    </message>
    <message>
        <source>Open Files</source>
        <translation>Bestanden openen</translation>
    </message>
    <message>
        <source>Meshes and scenes (%1);;All files (*)</source>
        <translation>Meshes en scènes (%1);;Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Open Folder</source>
        <translation>Map openen</translation>
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
        <translation>Melding</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>De melding sluiten</translation>
    </message>
    <message>
        <source>Opened, with remarks</source>
        <translation>Geopend, met opmerkingen</translation>
    </message>
    <message numerus="yes">
        <source>Show all %n</source>
        <translation>
            <numerusform>%n tonen</numerusform>
            <numerusform>Alle %n tonen</numerusform>
        </translation>
    </message>
    <message>
        <source>What was left out or mended</source>
        <translation>Wat weggelaten of hersteld is</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Voorkeuren</translation>
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
        <translation>Doorsnede: %1</translation>
    </message>
    <message>
        <source>Without %1 Section</source>
        <translation>Zonder doorsnede: %1</translation>
    </message>
    <message>
        <source>Flip Sections</source>
        <translation>Doorsneden omkeren</translation>
    </message>
    <message>
        <source>Whole Again</source>
        <translation>Weer heel</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
    <message>
        <source>Γ of %1</source>
        <translation>Γ van %1</translation>
    </message>
    <message numerus="yes">
        <source>Γ of %n items</source>
        <translation>
            <numerusform>Γ van %n onderdeel</numerusform>
            <numerusform>Γ van %n onderdelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 en nog %n</numerusform>
            <numerusform>%1 en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>No file that could be read again has changed</source>
        <translation>Geen bestand dat opnieuw gelezen kan worden is gewijzigd</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read again</source>
        <translation>
            <numerusform>%n structuur is opnieuw gelezen</numerusform>
            <numerusform>%n structuren zijn opnieuw gelezen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from source</source>
        <translation>Opnieuw laden van de bron</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 openen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTree</name>
    <message>
        <source>Filter structures by name</source>
        <translation>Structuren op naam filteren</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Op naam filteren</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kleur</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeModel</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Verborgen</translation>
    </message>
    <message>
        <source>Partly shown</source>
        <translation>Deels getoond</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Getoond</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kleur</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>%1, from the group above</source>
        <translation>%1, van de groep erboven</translation>
    </message>
    <message>
        <source>%1, structures: %2</source>
        <translation>%1, structuren: %2</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structuur</translation>
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
        <translation>Structuren</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewActions</name>
    <message>
        <source>Key Light</source>
        <translation>Hoofdlicht</translation>
    </message>
    <message>
        <source>View “%1”</source>
        <translation>Aanzicht ‘%1’</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Beeld</translation>
    </message>
</context>
</TS>
