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
    <message>
        <source>Opens a scene that the program models itself: %1.</source>
        <translation>Öffnet eine Szene, die das Programm selbst modelliert: %1.</translation>
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
    <message>
        <source>hides up to %1 % of it</source>
        <translation>verdeckt bis zu %1 % davon</translation>
    </message>
    <message>
        <source>%1 mm away</source>
        <translation>%1 mm entfernt</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Thin and long, comes to it</source>
        <translation>Dünn und lang, führt hin</translation>
    </message>
    <message>
        <source>Where %1 comes from</source>
        <translation>Woher %1 kommt</translation>
    </message>
    <message>
        <source>Lies against it</source>
        <translation>Liegt an</translation>
    </message>
    <message>
        <source>Lies outside, %1</source>
        <translation>Liegt außen, %1</translation>
    </message>
    <message>
        <source>In focus</source>
        <translation>Im Fokus</translation>
    </message>
    <message>
        <source>Vessel or duct</source>
        <translation>Gefäß oder Gang</translation>
    </message>
    <message>
        <source>Vessels and ducts</source>
        <translation>Gefäße und Gänge</translation>
    </message>
    <message>
        <source>Neighbour</source>
        <translation>Nachbar</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Hülle</translation>
    </message>
    <message>
        <source>Shells around it</source>
        <translation>Hüllen ringsum</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Keep unsaved work after</source>
        <translation>Ungespeichertes sichern nach</translation>
    </message>
    <message>
        <source>How long after a change a copy is kept, which is offered after a crash</source>
        <translation>Wie lange nach einer Änderung eine Kopie angelegt wird, die nach einem Absturz angeboten wird</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Its rights do not let it be written to</source>
        <translation>Ihre Rechte erlauben kein Schreiben</translation>
    </message>
    <message>
        <source>A newer version of the program has written it; what is unknown here is not shown</source>
        <translation>Eine neuere Version des Programms hat sie geschrieben; was hier unbekannt ist, wird nicht gezeigt</translation>
    </message>
    <message>
        <source>It was saved after this copy was made</source>
        <translation>Sie wurde gespeichert, nachdem diese Kopie entstand</translation>
    </message>
    <message>
        <source>Another program has changed it since</source>
        <translation>Ein anderes Programm hat sie seitdem geändert</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
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
        <source>Sline scenes (*.sline)</source>
        <translation>Sline-Szenen (*.sline)</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Changes that are not saved will be lost.</source>
        <translation>Nicht gespeicherte Änderungen gehen verloren.</translation>
    </message>
    <message>
        <source>Go back to “%1” as it was saved last?</source>
        <translation>Zu „%1“ zurückkehren, wie es zuletzt gespeichert wurde?</translation>
    </message>
    <message>
        <source>Undo brings back what was changed since.</source>
        <translation>Rückgängig bringt zurück, was seitdem geändert wurde.</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurückkehren</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>A scene without anything in it</source>
        <translation>Eine Szene ohne Inhalt</translation>
    </message>
    <message>
        <source>Open scenes, meshes, label volumes and other files</source>
        <translation>Szenen, Netze, Labelvolumen und andere Dateien öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Write the scene file</source>
        <translation>Die Szenendatei schreiben</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Write another scene file and go on with that</source>
        <translation>Eine andere Szenendatei schreiben und mit ihr weitermachen</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>&amp;Kopie speichern …</translation>
    </message>
    <message>
        <source>Write another scene file and go on with this one</source>
        <translation>Eine andere Szenendatei schreiben und mit dieser weitermachen</translation>
    </message>
    <message>
        <source>Re&amp;vert to Saved…</source>
        <translation>Zum &amp;Gespeicherten zurück …</translation>
    </message>
    <message>
        <source>Read the scene file again; what was changed since is undone</source>
        <translation>Die Szenendatei erneut lesen; was seitdem geändert wurde, ist zurückgenommen</translation>
    </message>
    <message>
        <source>Recover &amp;Unsaved Work…</source>
        <translation>Ungespeichertes &amp;wiederherstellen …</translation>
    </message>
    <message>
        <source>What was kept when the program did not end as it should</source>
        <translation>Was gesichert wurde, als das Programm nicht ordentlich endete</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close the scene and go to the start page</source>
        <translation>Die Szene schließen und zur Startseite gehen</translation>
    </message>
    <message>
        <source>The selected structures in detail, everything else by what it is to them</source>
        <translation>Die gewählten Strukturen in allen Einzelheiten, alles andere nach dem, was es für sie ist</translation>
    </message>
    <message>
        <source>&amp;Help on This</source>
        <translation>&amp;Hilfe hierzu</translation>
    </message>
    <message>
        <source>The page about the panel that has the keyboard</source>
        <translation>Die Seite zu dem Bedienfeld, das die Tastatur hat</translation>
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
    <name>sline::widgets::FileActions</name>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>it is no longer there</source>
        <translation>sie ist nicht mehr da</translation>
    </message>
    <message>
        <source>Open it from where it is now</source>
        <translation>Öffne sie dort, wo sie jetzt ist</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (schreibgeschützt)</translation>
    </message>
    <message>
        <source>%1[*] – Sline</source>
        <translation>%1[*] – Sline</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>%1 is open read-only</source>
        <translation>%1 ist nur zum Lesen geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusContext</name>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Focus from this view</source>
        <translation>Fokus aus dieser Ansicht</translation>
    </message>
    <message>
        <source>Focus all round</source>
        <translation>Fokus ringsum</translation>
    </message>
    <message>
        <source>nothing is left to focus on</source>
        <translation>es bleibt nichts für den Fokus übrig</translation>
    </message>
    <message>
        <source>Select something that no section takes away</source>
        <translation>Wähle etwas, das kein Schnitt wegnimmt</translation>
    </message>
    <message>
        <source>Role in the context</source>
        <translation>Rolle im Kontext</translation>
    </message>
    <message>
        <source>Hidden structures in the context</source>
        <translation>Ausgeblendete Strukturen im Kontext</translation>
    </message>
    <message>
        <source>Context %1 %</source>
        <translation>Kontext %1 %</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusPanel</name>
    <message>
        <source>As you said</source>
        <translation>Wie von dir bestimmt</translation>
    </message>
    <message>
        <source>Focus on Selection</source>
        <translation>Auswahl in den Fokus</translation>
    </message>
    <message>
        <source>These in detail, everything else by what it is to them</source>
        <translation>Diese in allen Einzelheiten, alles andere nach dem, was es für sie ist</translation>
    </message>
    <message>
        <source>How much context</source>
        <translation>Wie viel Kontext</translation>
    </message>
    <message>
        <source>Focus alone</source>
        <translation>Nur Fokus</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>All Round</source>
        <translation>Ringsum</translation>
    </message>
    <message>
        <source>Nothing hides the focus from whatever side it is seen</source>
        <translation>Nichts verdeckt den Fokus, von welcher Seite man ihn auch sieht</translation>
    </message>
    <message>
        <source>This View</source>
        <translation>Diese Ansicht</translation>
    </message>
    <message>
        <source>Nothing hides the focus as it is seen now; what lies behind it may be solid</source>
        <translation>Nichts verdeckt den Fokus, wie man ihn jetzt sieht; was dahinter liegt, darf deckend sein</translation>
    </message>
    <message>
        <source>What each structure is to the focus</source>
        <translation>Was jede Struktur für den Fokus ist</translation>
    </message>
    <message>
        <source>Treat as</source>
        <translation>Behandeln als</translation>
    </message>
    <message>
        <source>&amp;Treat as</source>
        <translation>Be&amp;handeln als</translation>
    </message>
    <message>
        <source>Nothing in focus</source>
        <translation>Nichts im Fokus</translation>
    </message>
    <message numerus="yes">
        <source>%n structures in focus</source>
        <translation>
            <numerusform>%n Struktur im Fokus</numerusform>
            <numerusform>%n Strukturen im Fokus</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking at what surrounds it…</source>
        <translation>Die Umgebung wird untersucht …</translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Wähle eine Struktur in der Liste oder im Bild.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Also what was hidden</source>
        <translation>Auch Ausgeblendetes</translation>
    </message>
    <message numerus="yes">
        <source>Also %n hidden structures</source>
        <translation>
            <numerusform>Auch %n ausgeblendete Struktur</numerusform>
            <numerusform>Auch %n ausgeblendete Strukturen</numerusform>
        </translation>
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
    <name>sline::widgets::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Search in help</source>
        <translation>In der Hilfe suchen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Open in the Browser?</source>
        <translation>Im Browser öffnen?</translation>
    </message>
    <message>
        <source>This link leads out of the program, to
%1</source>
        <translation>Dieser Verweis führt aus dem Programm hinaus, zu
%1</translation>
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
        <source>Focus and Context</source>
        <translation>Fokus und Kontext</translation>
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
    <name>sline::widgets::RecoveryDialog</name>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>Ungespeichertes wiederherstellen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Das Programm endete nicht ordentlich. Es hatte gesichert:</translation>
    </message>
</context>
<context>
    <name>sline::widgets::RecoveryList</name>
    <message>
        <source>A damaged copy</source>
        <translation>Eine beschädigte Kopie</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Delete the unsaved work on “%1”?</source>
        <translation>Ungespeicherte Arbeit an „%1“ löschen?</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Sie lässt sich nicht zurückholen.</translation>
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
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
    <message>
        <source>Revert to Saved</source>
        <translation>Zum Gespeicherten zurück</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StartPage</name>
    <message>
        <source>Opened Last</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Demos, Modelled by the Program</source>
        <translation>Demos, vom Programm modelliert</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>Focus-and-context line drawings of anatomy</source>
        <translation>Linienzeichnungen der Anatomie mit Fokus und Kontext</translation>
    </message>
    <message>
        <source>Open Files…</source>
        <translation>Dateien öffnen …</translation>
    </message>
    <message>
        <source>Open Folder…</source>
        <translation>Ordner öffnen …</translation>
    </message>
    <message>
        <source>or drop files and folders into this window</source>
        <translation>oder Dateien und Ordner in dieses Fenster ziehen</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Das Programm endete nicht ordentlich. Es hatte gesichert:</translation>
    </message>
    <message>
        <source>no longer there</source>
        <translation>nicht mehr da</translation>
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
