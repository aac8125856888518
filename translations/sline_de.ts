<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Told</name>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>vertex %1 in %2</source>
        <translation>Ecke %1 in %2</translation>
    </message>
    <message>
        <source>it cannot be written: %1</source>
        <translation>kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>it cannot be put in its place: %1</source>
        <translation>kann nicht an seinen Platz gebracht werden: %1</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>its folder cannot be written to: %1</source>
        <translation>in den Ordner kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>it is open for writing in %1</source>
        <translation>ist zum Schreiben geöffnet in: %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>einem anderen Programm</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>%1; the file that was there is whole, as it was</source>
        <translation>%1; die Datei, die dort war, ist unversehrt</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>ist größer als %1 Byte</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>der Ordner kann nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>it is a file, and a folder is to be made</source>
        <translation>ist eine Datei, angelegt werden soll ein Ordner</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>der Ordner kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>der Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>no temporary folder can be made here: %1</source>
        <translation>hier kann kein Ordner für Zwischendateien angelegt werden: %1</translation>
    </message>
    <message>
        <source>Choose a folder that exists and that you may write to</source>
        <translation>Wähle einen Ordner, den es gibt und in den du schreiben darfst</translation>
    </message>
    <message>
        <source>Choose a place that exists and that you may write to</source>
        <translation>Wähle einen Platz, den es gibt und an den du schreiben darfst</translation>
    </message>
    <message>
        <source>Free some space on the disk, or choose another one</source>
        <translation>Schaffe Platz auf dem Datenträger oder wähle einen anderen</translation>
    </message>
    <message>
        <source>Free some space on its disk</source>
        <translation>Schaffe Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>Check the rights of its folder</source>
        <translation>Prüfe die Rechte des Ordners</translation>
    </message>
    <message>
        <source>Check the name and the rights</source>
        <translation>Prüfe Namen und Rechte</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>Nenne eine Datei</translation>
    </message>
    <message>
        <source>Name the right file</source>
        <translation>Nenne die richtige Datei</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet</source>
        <translation>Nenne einen Ordner, den es noch nicht gibt</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet, or an empty one</source>
        <translation>Nenne einen Ordner, den es noch nicht gibt oder der leer ist</translation>
    </message>
    <message>
        <source>Save it under another name or in another folder</source>
        <translation>Speichere unter anderem Namen oder in einem anderen Ordner</translation>
    </message>
    <message>
        <source>Close it there, or save it under another name</source>
        <translation>Schließe sie dort oder speichere unter anderem Namen</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Speichere unter anderem Namen</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>it is no whole ZIP file: %1</source>
        <translation>ist keine vollständige ZIP-Datei: %1</translation>
    </message>
    <message>
        <source>it is cut or damaged</source>
        <translation>ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>it holds no scene.json: it is a ZIP file, but no scene</source>
        <translation>enthält keine scene.json: eine ZIP-Datei, aber keine Szene</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>ist zu groß</translation>
    </message>
    <message>
        <source>a newer version of the program has written it, with more than this one would write</source>
        <translation>eine neuere Version des Programms hat sie geschrieben, mit mehr als diese schreiben würde</translation>
    </message>
    <message>
        <source>it was damaged, and holds no state of the scene that is whole</source>
        <translation>war beschädigt und enthält keinen vollständigen Stand der Szene</translation>
    </message>
    <message>
        <source>Open an older copy of it, or import the meshes again</source>
        <translation>Öffne eine ältere Kopie oder importiere die Netze erneut</translation>
    </message>
    <message>
        <source>Open the scene file as it was saved last</source>
        <translation>Öffne die Szenendatei, wie sie zuletzt gespeichert wurde</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>is a folder, not a mesh file</source>
        <translation>ist ein Ordner, keine Netzdatei</translation>
    </message>
    <message>
        <source>is a device or pipe, not a file</source>
        <translation>ist ein Gerät oder eine Pipe, keine Datei</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>its size cannot be found: %1</source>
        <translation>die Größe lässt sich nicht ermitteln: %1</translation>
    </message>
    <message>
        <source>has %1 bytes, the limit is %2</source>
        <translation>hat %1 Byte, die Grenze ist %2</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory</source>
        <translation>braucht %1 Byte Speicher</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory when unpacked</source>
        <translation>braucht entpackt %1 Byte Speicher</translation>
    </message>
    <message>
        <source>cannot be read any further</source>
        <translation>kann nicht weiter gelesen werden</translation>
    </message>
    <message>
        <source>its packed bytes end in the middle</source>
        <translation>die gepackten Bytes enden mittendrin</translation>
    </message>
    <message>
        <source>holds nothing when unpacked</source>
        <translation>enthält entpackt nichts</translation>
    </message>
    <message>
        <source>this kind of file is not supported</source>
        <translation>diese Art von Datei wird nicht unterstützt</translation>
    </message>
    <message>
        <source>has no extension that tells its kind</source>
        <translation>hat keine Endung, die ihre Art nennt</translation>
    </message>
    <message>
        <source>files of kind &apos;%1&apos; are not supported</source>
        <translation>Dateien der Art „%1“ werden nicht unterstützt</translation>
    </message>
    <message>
        <source>%1; its content looks like %2</source>
        <translation>%1; der Inhalt sieht aus wie: %2</translation>
    </message>
    <message>
        <source>the folder holds no mesh</source>
        <translation>der Ordner enthält kein Netz</translation>
    </message>
    <message>
        <source>%1 is an archive and was not looked into</source>
        <translation>%1 ist ein Archiv, in das nicht hineingesehen wurde</translation>
    </message>
    <message>
        <source>%1 are archives and were not looked into</source>
        <translation>%1 sind Archive, in die nicht hineingesehen wurde</translation>
    </message>
    <message>
        <source>is an archive, which is not looked into</source>
        <translation>ist ein Archiv, in das nicht hineingesehen wird</translation>
    </message>
    <message>
        <source>Unpack it and open what was in it</source>
        <translation>Entpacke es und öffne, was darin war</translation>
    </message>
    <message>
        <source>Open a bundle of 3D Slicer (.mrb) by itself; unpack any other and open what was in it</source>
        <translation>Öffne ein Paket von 3D Slicer (.mrb) für sich; entpacke alles andere und öffne, was darin war</translation>
    </message>
    <message>
        <source>the scene holds no model</source>
        <translation>die Szene enthält kein Modell</translation>
    </message>
    <message>
        <source>none of the scene&apos;s %1 model files can be found</source>
        <translation>keine der %1 Modelldateien der Szene ist zu finden</translation>
    </message>
    <message>
        <source>there is nothing to read</source>
        <translation>es gibt nichts zu lesen</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>der Import wurde abgebrochen</translation>
    </message>
    <message>
        <source>all structures are left out</source>
        <translation>alle Strukturen sind ausgelassen</translation>
    </message>
    <message>
        <source>nothing is made of the scan yet</source>
        <translation>aus der Aufnahme ist noch nichts gemacht</translation>
    </message>
    <message>
        <source>holds no triangles</source>
        <translation>enthält keine Dreiecke</translation>
    </message>
    <message>
        <source>holds no vertices</source>
        <translation>enthält keine Ecken</translation>
    </message>
    <message>
        <source>holds vertices but no faces</source>
        <translation>enthält Ecken, aber keine Flächen</translation>
    </message>
    <message>
        <source>holds no faces, only lines or points</source>
        <translation>enthält keine Flächen, nur Linien oder Punkte</translation>
    </message>
    <message>
        <source>this is not a statement of an OBJ file</source>
        <translation>das ist keine Anweisung einer OBJ-Datei</translation>
    </message>
    <message>
        <source>Check that the file is an OBJ file</source>
        <translation>Prüfe, ob die Datei eine OBJ-Datei ist</translation>
    </message>
    <message>
        <source>Export the mesh as a surface with faces</source>
        <translation>Exportiere das Netz als Oberfläche mit Flächen</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;ply&apos;</source>
        <translation>die Datei beginnt nicht mit „ply“</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;OFF&apos;</source>
        <translation>die Datei beginnt nicht mit „OFF“</translation>
    </message>
    <message>
        <source>%1 stands where %2 should</source>
        <translation>%1 steht, wo %2 stehen sollte</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>die Datei endet nach %1</translation>
    </message>
    <message>
        <source>the file ends within a face</source>
        <translation>die Datei endet mitten in einer Fläche</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles are more than the limit</source>
        <translation>%1 Ecken und %2 Dreiecke sind mehr als erlaubt</translation>
    </message>
    <message>
        <source>%1 of %2 faces refer to vertices that do not exist (there are %3 vertices)</source>
        <translation>%1 von %2 Flächen verweisen auf Ecken, die es nicht gibt (es gibt %3 Ecken)</translation>
    </message>
    <message>
        <source>%1 of %2 vertices are not finite numbers</source>
        <translation>%1 von %2 Ecken sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>the reader of %1 files crashed over this file (%2)</source>
        <translation>der Leser von %1-Dateien ist über dieser Datei abgestürzt (%2)</translation>
    </message>
    <message>
        <source>the reader of %1 files wanted more than %2 of memory for this file</source>
        <translation>der Leser von %1-Dateien wollte für diese Datei mehr als %2 Speicher</translation>
    </message>
    <message>
        <source>the reader of %1 files did not come to an end within %2 s of computing</source>
        <translation>der Leser von %1-Dateien kam in %2 s Rechenzeit zu keinem Ende</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>a library failed: %1</source>
        <translation>eine Bibliothek ist gescheitert: %1</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Prüfe den Namen</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Prüfe den Pfad</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Prüfe den Datenträger</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Prüfe die Rechte</translation>
    </message>
    <message>
        <source>Check the disk or copy the file again</source>
        <translation>Prüfe den Datenträger oder kopiere die Datei noch einmal</translation>
    </message>
    <message>
        <source>Copy the file again</source>
        <translation>Kopiere die Datei noch einmal</translation>
    </message>
    <message>
        <source>Copy the data to a file</source>
        <translation>Kopiere die Daten in eine Datei</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Schließe andere Programme</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Schließe andere Programme und versuche es noch einmal</translation>
    </message>
    <message>
        <source>Reduce the mesh</source>
        <translation>Verkleinere das Netz</translation>
    </message>
    <message>
        <source>Name a file inside it</source>
        <translation>Nenne eine Datei darin</translation>
    </message>
    <message>
        <source>Name a mesh, a folder or a scene</source>
        <translation>Nenne ein Netz, einen Ordner oder eine Szene</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Möglich sind %1</translation>
    </message>
    <message>
        <source>%1, many of them packed (.gz) too</source>
        <translation>%1, viele davon auch gepackt (.gz)</translation>
    </message>
    <message>
        <source>Give a file of surfaces (%1), a folder of them, a 3D Slicer scene (.mrml, .mrb) or its fiducials (%2), or a scene file (.sline)</source>
        <translation>Möglich sind eine Datei mit Oberflächen (%1), ein Ordner davon, eine Szene von 3D Slicer (.mrml, .mrb) oder deren Marken (%2) oder eine Szenendatei (.sline)</translation>
    </message>
    <message>
        <source>Export the mesh again from the program that made it</source>
        <translation>Exportiere das Netz noch einmal aus dem Programm, das es gemacht hat</translation>
    </message>
    <message>
        <source>Export the mesh as a surface of triangles</source>
        <translation>Exportiere das Netz als Oberfläche aus Dreiecken</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind or export the mesh again</source>
        <translation>Gib der Datei die Endung ihrer Art oder exportiere das Netz noch einmal</translation>
    </message>
    <message>
        <source>It may be damaged: export it again, or in another format</source>
        <translation>Die Datei ist vielleicht beschädigt: Exportiere sie noch einmal oder in einem anderen Format</translation>
    </message>
    <message>
        <source>Keep the scene beside its model files, or save it again with its models</source>
        <translation>Lass die Szene bei ihren Modelldateien oder speichere sie noch einmal mit den Modellen</translation>
    </message>
    <message>
        <source>None of the files could be read</source>
        <translation>Keine der Dateien ließ sich lesen</translation>
    </message>
    <message>
        <source>Include at least one</source>
        <translation>Nimm mindestens eine auf</translation>
    </message>
    <message>
        <source>Make a structure of it by a threshold, or keep it with the scene</source>
        <translation>Mache durch einen Schwellenwert eine Struktur daraus oder behalte sie bei der Szene</translation>
    </message>
    <message>
        <source>%1; they are left out</source>
        <translation>%1; sie sind ausgelassen</translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation>%1; ausgelassen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>ausgelassen: %1</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <translation>%1 wurde ausgelassen: %2</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>keine Dreiecke</translation>
    </message>
    <message>
        <source>no triangles in %1</source>
        <translation>keine Dreiecke in %1</translation>
    </message>
    <message>
        <source>%1 of %2 faces have fewer than three corners and are left out</source>
        <translation>%1 von %2 Flächen haben weniger als drei Ecken und sind ausgelassen</translation>
    </message>
    <message>
        <source>%1 (the first: %2); they and the %3 triangles that use them are left out</source>
        <translation>%1 (die erste: %2); sie und die %3 Dreiecke, die sie benutzen, sind ausgelassen</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surface: %3 left out</source>
        <translation>%1 von %2 Oberfläche ausgebessert: %3 ausgelassen</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surfaces: %3 left out</source>
        <translation>%1 von %2 Oberflächen ausgebessert: %3 ausgelassen</translation>
    </message>
    <message>
        <source>%1 face given twice</source>
        <translation>%1 doppelte Fläche</translation>
    </message>
    <message>
        <source>%1 faces given twice</source>
        <translation>%1 doppelte Flächen</translation>
    </message>
    <message>
        <source>%1 face without area</source>
        <translation>%1 Fläche ohne Inhalt</translation>
    </message>
    <message>
        <source>%1 faces without area</source>
        <translation>%1 Flächen ohne Inhalt</translation>
    </message>
    <message>
        <source>%1 face given twice, %2 without area</source>
        <translation>%1 doppelte Fläche, %2 ohne Inhalt</translation>
    </message>
    <message>
        <source>%1 faces given twice, %2 without area</source>
        <translation>%1 doppelte Flächen, %2 ohne Inhalt</translation>
    </message>
    <message>
        <source>a piece of %1 has no consistent orientation; it stays as it is</source>
        <translation>ein Stück von %1 hat keine einheitliche Ausrichtung; es bleibt, wie es ist</translation>
    </message>
    <message>
        <source>%1 has no face with area; left out</source>
        <translation>%1 hat keine Fläche mit Inhalt; ausgelassen</translation>
    </message>
    <message>
        <source>its file has changed or is gone</source>
        <translation>die Datei hat sich geändert oder ist fort</translation>
    </message>
    <message>
        <source>no threshold made a structure: no scan was read that has it</source>
        <translation>kein Schwellenwert hat eine Struktur ergeben: keine gelesene Aufnahme hat ihn</translation>
    </message>
    <message>
        <source>the folder could not be read to its end: %1</source>
        <translation>der Ordner ließ sich nicht bis zum Ende lesen: %1</translation>
    </message>
    <message>
        <source>the folder was not searched to its end: %1</source>
        <translation>der Ordner wurde nicht bis zum Ende durchsucht: %1</translation>
    </message>
    <message>
        <source>it holds too many files</source>
        <translation>er enthält zu viele Dateien</translation>
    </message>
    <message>
        <source>the file is absent; it was left out</source>
        <translation>die Datei fehlt; sie wurde ausgelassen</translation>
    </message>
    <message>
        <source>the scene refers to a place outside its folder; it was left out</source>
        <translation>die Szene verweist auf einen Platz außerhalb ihres Ordners; er wurde ausgelassen</translation>
    </message>
    <message>
        <source>a scene file is in millimetres of the patient&apos;s frame; the frame and the unit that were chosen do not apply to it</source>
        <translation>eine Szenendatei steht in Millimetern im Koordinatensystem des Patienten; gewähltes Koordinatensystem und Einheit gelten für sie nicht</translation>
    </message>
    <message>
        <source>surfaces of a scene file keep their triangles; only what is imported is decimated</source>
        <translation>Oberflächen einer Szenendatei behalten ihre Dreiecke; vereinfacht wird nur, was importiert wird</translation>
    </message>
    <message>
        <source>%1 structure left out that the folder also holds as surfaces</source>
        <translation>%1 Struktur ausgelassen, die der Ordner auch als Oberflächen enthält</translation>
    </message>
    <message>
        <source>%1 structures left out that the folder also holds as surfaces</source>
        <translation>%1 Strukturen ausgelassen, die der Ordner auch als Oberflächen enthält</translation>
    </message>
    <message>
        <source>a scan, of which a threshold can make a structure: %1</source>
        <translation>eine Aufnahme, aus der ein Schwellenwert eine Struktur machen kann: %1</translation>
    </message>
    <message>
        <source>the scan cannot be kept: %1</source>
        <translation>die Aufnahme kann nicht behalten werden: %1</translation>
    </message>
    <message>
        <source>%1 holds no segmentation</source>
        <translation>%1 enthält keine Segmentierung</translation>
    </message>
    <message>
        <source>%1 hold no segmentation</source>
        <translation>%1 enthalten keine Segmentierung</translation>
    </message>
    <message>
        <source>%1 line and point elements are left out; only faces are read</source>
        <translation>%1 Linien und Punkte sind ausgelassen; gelesen werden nur Flächen</translation>
    </message>
    <message>
        <source>%1 statements are unknown and left out (the first: %2)</source>
        <translation>%1 Anweisungen sind unbekannt und ausgelassen (die erste: %2)</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle of the %2 promised are ignored</source>
        <translation>%1 Byte nach dem letzten der %2 angekündigten Dreiecke sind übergangen</translation>
    </message>
    <message>
        <source>has neither sform nor qform: which side is left is taken from names, if they tell</source>
        <translation>hat weder sform noch qform: Welche Seite links ist, sagen die Namen, wenn sie es sagen</translation>
    </message>
    <message>
        <source>holds %1 images of one place; the first was read</source>
        <translation>enthält %1 Bilder desselben Ortes; gelesen wurde das erste</translation>
    </message>
    <message>
        <source>intensities were rounded to 16 bits, by at most %1</source>
        <translation>Helligkeiten wurden auf 16 Bit gerundet, um höchstens %1</translation>
    </message>
    <message>
        <source>%1 masks hold nothing and were left out: %2</source>
        <translation>%1 Masken enthalten nichts und wurden ausgelassen: %2</translation>
    </message>
    <message>
        <source>%1 atom without coordinates left out</source>
        <translation>%1 Atom ohne Koordinaten ausgelassen</translation>
    </message>
    <message>
        <source>%1 atoms without coordinates left out</source>
        <translation>%1 Atome ohne Koordinaten ausgelassen</translation>
    </message>
    <message>
        <source>%1 further model left out; the first is drawn</source>
        <translation>%1 weiteres Modell ausgelassen; gezeichnet ist das erste</translation>
    </message>
    <message>
        <source>%1 further models left out; the first is drawn</source>
        <translation>%1 weitere Modelle ausgelassen; gezeichnet ist das erste</translation>
    </message>
    <message>
        <source>chain %1 laid over chain %2 of %3: %4 of %5 pairs of residues, %6 % identical, RMSD %7</source>
        <translation>Kette %1 über Kette %2 von %3 gelegt: %4 von %5 Paaren von Resten, %6 % gleich, RMSD %7</translation>
    </message>
    <message>
        <source>not laid over %1, since no chains match; it stays where its file has it</source>
        <translation>nicht über %1 gelegt, da keine Ketten zueinander passen; bleibt, wo die Datei es hat</translation>
    </message>
    <message>
        <source>no file of this name was found</source>
        <translation>keine Datei dieses Namens wurde gefunden</translation>
    </message>
    <message>
        <source>only files that other structures came from were found</source>
        <translation>gefunden wurden nur Dateien, aus denen andere Strukturen stammen</translation>
    </message>
    <message>
        <source>there are %1 files of this name; name the folder of the one that is meant</source>
        <translation>es gibt %1 Dateien dieses Namens; nenne den Ordner der gemeinten</translation>
    </message>
    <message>
        <source>structures from several files of this name are in the scene</source>
        <translation>in der Szene sind Strukturen aus mehreren Dateien dieses Namens</translation>
    </message>
    <message>
        <source>no structure of the scene came from these of its surfaces: %1</source>
        <translation>aus diesen ihrer Oberflächen stammt keine Struktur der Szene: %1</translation>
    </message>
    <message>
        <source>it holds no surface %1 any more</source>
        <translation>enthält keine Oberfläche %1 mehr</translation>
    </message>
    <message>
        <source>it has no face with area any more</source>
        <translation>hat keine Fläche mit Inhalt mehr</translation>
    </message>
    <message>
        <source>chosen by the user</source>
        <translation>von dir gewählt</translation>
    </message>
    <message>
        <source>no header and no left/right names: LPS assumed</source>
        <translation>weder Kopf noch Namen mit Seite: LPS angenommen</translation>
    </message>
    <message>
        <source>vote: %1 of %2 left/right names</source>
        <translation>Abstimmung: %1 von %2 Namen mit Seite</translation>
    </message>
    <message>
        <source>header: %1</source>
        <translation>Kopf der Datei: %1</translation>
    </message>
    <message>
        <source>coordinates left as they are</source>
        <translation>Koordinaten, wie sie sind</translation>
    </message>
    <message>
        <source>scene of Slicer: millimetres</source>
        <translation>Szene von Slicer: Millimeter</translation>
    </message>
    <message>
        <source>no unit in the file: millimetres assumed</source>
        <translation>keine Einheit in der Datei: Millimeter angenommen</translation>
    </message>
    <message>
        <source>SPACE in the header</source>
        <translation>SPACE im Kopf</translation>
    </message>
    <message>
        <source>SPACE in a comment</source>
        <translation>SPACE in einem Kommentar</translation>
    </message>
    <message>
        <source>SPACE in the field data</source>
        <translation>SPACE in den Felddaten</translation>
    </message>
    <message>
        <source>SPACE in the title</source>
        <translation>SPACE im Titel</translation>
    </message>
    <message>
        <source>DICOM: patient coordinates</source>
        <translation>DICOM: Koordinaten des Patienten</translation>
    </message>
    <message>
        <source>DICOM: millimetres</source>
        <translation>DICOM: Millimeter</translation>
    </message>
    <message>
        <source>glTF: metres</source>
        <translation>glTF: Meter</translation>
    </message>
    <message>
        <source>header: millimetres</source>
        <translation>Kopf der Datei: Millimeter</translation>
    </message>
    <message>
        <source>volumes are in millimetres</source>
        <translation>Volumen stehen in Millimetern</translation>
    </message>
    <message>
        <source>modelled in it</source>
        <translation>darin modelliert</translation>
    </message>
    <message>
        <source>scene file</source>
        <translation>Szenendatei</translation>
    </message>
    <message>
        <source>a molecule has no left and right</source>
        <translation>ein Molekül hat kein Links und Rechts</translation>
    </message>
    <message>
        <source>1 Å is drawn as 1 mm</source>
        <translation>1 Å ist als 1 mm gezeichnet</translation>
    </message>
    <message>
        <source>the export was stopped</source>
        <translation>der Export wurde abgebrochen</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Exportiere noch einmal</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large</source>
        <translation>ein Bild von %1 Pixeln ist zu groß</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large for this kind of file</source>
        <translation>ein Bild von %1 Pixeln ist für diese Art von Datei zu groß</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page; a side may have %1 pixels in this kind of file</source>
        <translation>Wähle weniger Punkte je Zoll oder eine kleinere Seite; in dieser Art von Datei darf eine Seite %1 Pixel haben</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page, or PNG or TIFF; a picture may have %1 million pixels here</source>
        <translation>Wähle weniger Punkte je Zoll, eine kleinere Seite oder PNG oder TIFF; hier darf ein Bild %1 Millionen Pixel haben</translation>
    </message>
    <message>
        <source>the picture cannot be written: %1</source>
        <translation>das Bild kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Choose a smaller picture or another kind of file</source>
        <translation>Wähle ein kleineres Bild oder eine andere Art von Datei</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>the picture has no labels to ask for</source>
        <translation>das Bild hat keine Beschriftungen, nach denen zu fragen wäre</translation>
    </message>
    <message>
        <source>Label structures, or choose a view that shows some</source>
        <translation>Beschrifte Strukturen oder wähle eine Ansicht, die welche zeigt</translation>
    </message>
    <message>
        <source>the scene needs more than the 4 GB that a GLB file may have</source>
        <translation>die Szene braucht mehr als die 4 GB, die eine GLB-Datei haben darf</translation>
    </message>
    <message>
        <source>Hide structures, or make them coarser</source>
        <translation>Blende Strukturen aus oder mache sie gröber</translation>
    </message>
    <message>
        <source>a film takes 0.1 to 600 seconds</source>
        <translation>ein Film dauert 0,1 bis 600 Sekunden</translation>
    </message>
    <message>
        <source>Choose another length</source>
        <translation>Wähle eine andere Dauer</translation>
    </message>
    <message>
        <source>a film has 1 to 60 frames per second</source>
        <translation>ein Film hat 1 bis 60 Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Choose another rate</source>
        <translation>Wähle eine andere Rate</translation>
    </message>
    <message>
        <source>Save views, or make a turntable</source>
        <translation>Speichere Ansichten oder mache eine Drehung</translation>
    </message>
    <message>
        <source>MP4 films are made by the program ffmpeg, which is not installed</source>
        <translation>MP4-Filme macht das Programm ffmpeg, das nicht installiert ist</translation>
    </message>
    <message>
        <source>Install ffmpeg, or write an animated WebP or GIF</source>
        <translation>Installiere ffmpeg oder schreibe ein bewegtes WebP oder GIF</translation>
    </message>
    <message>
        <source>GIF films show at most 50 frames per second</source>
        <translation>GIF-Filme zeigen höchstens 50 Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Choose 50 or fewer, or another kind of film</source>
        <translation>Wähle 50 oder weniger oder eine andere Art von Film</translation>
    </message>
    <message>
        <source>the picture could not be drawn: %1</source>
        <translation>das Bild ließ sich nicht zeichnen: %1</translation>
    </message>
    <message>
        <source>Hide some structures, or close other programs to free memory</source>
        <translation>Blende einige Strukturen aus oder schließe andere Programme, um Speicher freizugeben</translation>
    </message>
    <message>
        <source>the structures of this scene do not fit into the memory set aside for a picture, not even piece by piece</source>
        <translation>die Strukturen dieser Szene passen nicht in den Speicher, der für ein Bild vorgesehen ist, auch nicht stückweise</translation>
    </message>
    <message>
        <source>Hide some structures</source>
        <translation>Blende einige Strukturen aus</translation>
    </message>
    <message>
        <source>the driver %1 is too old: OpenGL 3.3 or OpenGL ES 3.0 is needed</source>
        <translation>der Treiber %1 ist zu alt: OpenGL 3.3 oder OpenGL ES 3.0 ist nötig</translation>
    </message>
    <message>
        <source>Update the graphics driver, or install Mesa (libgl1-mesa-dri)</source>
        <translation>Aktualisiere den Grafiktreiber oder installiere Mesa (libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht vorhanden</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger lässt sich nur lesen</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Fehler beim Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>it is no scene of Sline</source>
        <translation>ist keine Szene von Sline</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>ist verschlüsselt</translation>
    </message>
    <message>
        <source>it cannot be unpacked: %1</source>
        <translation>kann nicht entpackt werden: %1</translation>
    </message>
    <message>
        <source>the unit of %1 has no length</source>
        <translation>die Einheit von %1 hat keine Länge</translation>
    </message>
    <message>
        <source>Choose a unit</source>
        <translation>Wähle eine Einheit</translation>
    </message>
    <message>
        <source>the steps of smoothing of %1 are out of range</source>
        <translation>die Zahl der Glättungsschritte von %1 ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the bound for decimation of %1 is out of range</source>
        <translation>die Grenze für die Vereinfachung von %1 ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Choose 0 to %1</source>
        <translation>Wähle 0 bis %1</translation>
    </message>
    <message>
        <source>the name of %1 is empty</source>
        <translation>der Name von %1 ist leer</translation>
    </message>
    <message>
        <source>Give it a name</source>
        <translation>Gib ihr einen Namen</translation>
    </message>
    <message>
        <source>Plan the import again</source>
        <translation>Plane den Import noch einmal</translation>
    </message>
    <message>
        <source>the reader of %1 files gave no answer for this file</source>
        <translation>der Leser von %1-Dateien gab für diese Datei keine Antwort</translation>
    </message>
    <message>
        <source>the program that reads it gave no answer</source>
        <translation>das Programm, das sie liest, gab keine Antwort</translation>
    </message>
    <message>
        <source>there is no memory to read it</source>
        <translation>zum Lesen fehlt Speicher</translation>
    </message>
    <message>
        <source>reading was given up</source>
        <translation>das Lesen wurde aufgegeben</translation>
    </message>
    <message>
        <source>%1 files are read by sline-reader, which is not beside Sline</source>
        <translation>%1-Dateien liest sline-reader, das nicht bei Sline liegt</translation>
    </message>
    <message>
        <source>Install Sline again</source>
        <translation>Installiere Sline noch einmal</translation>
    </message>
    <message>
        <source>Export the file again, or in another format</source>
        <translation>Exportiere die Datei noch einmal oder in einem anderen Format</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>braucht mehr Speicher, als es gibt</translation>
    </message>
    <message>
        <source>Import it again</source>
        <translation>Importiere sie noch einmal</translation>
    </message>
    <message>
        <source>its packed bytes are damaged: they cannot be unpacked beyond byte %1</source>
        <translation>die gepackten Bytes sind beschädigt: über Byte %1 hinaus lassen sie sich nicht entpacken</translation>
    </message>
    <message>
        <source>too short for an STL file: not text, and its %1 bytes do not hold the header of 84</source>
        <translation>zu kurz für eine STL-Datei: kein Text, und in %1 Byte passt der Kopf von 84 nicht</translation>
    </message>
    <message>
        <source>the file neither begins with &apos;solid&apos; nor has the size of a binary STL file</source>
        <translation>die Datei beginnt weder mit „solid“ noch hat sie die Größe einer binären STL-Datei</translation>
    </message>
    <message>
        <source>Check that the file is an STL file</source>
        <translation>Prüfe, ob die Datei eine STL-Datei ist</translation>
    </message>
    <message>
        <source>the header promises %1 triangles, the file ends after %2</source>
        <translation>der Kopf verspricht %1 Dreiecke, die Datei endet nach %2</translation>
    </message>
    <message>
        <source>the file ends where %1 should follow</source>
        <translation>die Datei endet, wo %1 folgen sollte</translation>
    </message>
    <message>
        <source>has no element &apos;vertex&apos;</source>
        <translation>hat kein Element „vertex“</translation>
    </message>
    <message>
        <source>holds points but no element &apos;face&apos; or &apos;tristrips&apos;</source>
        <translation>enthält Punkte, aber kein Element „face“ oder „tristrips“</translation>
    </message>
    <message>
        <source>the header has no &apos;end_header&apos;</source>
        <translation>der Kopf hat kein „end_header“</translation>
    </message>
    <message>
        <source>binary OFF is not supported</source>
        <translation>binäres OFF wird nicht unterstützt</translation>
    </message>
    <message>
        <source>Export the mesh as text OFF</source>
        <translation>Exportiere das Netz als OFF in Textform</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>the volume holds nothing but background</source>
        <translation>das Volumen enthält nichts als Hintergrund</translation>
    </message>
    <message>
        <source>Choose a volume with structures</source>
        <translation>Wähle ein Volumen mit Strukturen</translation>
    </message>
    <message>
        <source>the borders of its structures have more than %1</source>
        <translation>die Grenzen der Strukturen haben mehr als %1</translation>
    </message>
    <message>
        <source>its structures have more than %1</source>
        <translation>die Strukturen haben mehr als %1</translation>
    </message>
    <message>
        <source>Check that it is a label volume, or export it with larger voxels</source>
        <translation>Prüfe, ob es ein Labelvolumen ist, oder exportiere es mit größeren Voxeln</translation>
    </message>
    <message>
        <source>does not begin like a header of NIfTI or Analyze</source>
        <translation>beginnt nicht wie ein Kopf von NIfTI oder Analyze</translation>
    </message>
    <message>
        <source>has %1 axes, a volume needs three</source>
        <translation>hat %1 Achsen, ein Volumen braucht drei</translation>
    </message>
    <message>
        <source>Export a volume with three axes in space</source>
        <translation>Exportiere ein Volumen mit drei Achsen im Raum</translation>
    </message>
    <message>
        <source>does not begin like a volume of FreeSurfer (MGH)</source>
        <translation>beginnt nicht wie ein Volumen von FreeSurfer (MGH)</translation>
    </message>
    <message>
        <source>Put both files into one folder, or export the volume as one .nii file</source>
        <translation>Lege beide Dateien in einen Ordner oder exportiere das Volumen als eine .nii-Datei</translation>
    </message>
    <message>
        <source>is DICOM of a kind that is not known here and holds no segmentation</source>
        <translation>ist DICOM einer hier unbekannten Art und enthält keine Segmentierung</translation>
    </message>
    <message>
        <source>holds no segmentation: its content is of the kind %1</source>
        <translation>enthält keine Segmentierung: der Inhalt ist von der Art %1</translation>
    </message>
    <message>
        <source>Give the DICOM segmentation or RT structure set that was made from it</source>
        <translation>Öffne die DICOM-Segmentierung oder den RT-Struktursatz, der daraus gemacht wurde</translation>
    </message>
    <message>
        <source>Copy or export the file again; it is incomplete or damaged</source>
        <translation>Kopiere oder exportiere die Datei noch einmal; sie ist unvollständig oder beschädigt</translation>
    </message>
    <message>
        <source>the file ends within an element, or an element promises more bytes than are left</source>
        <translation>die Datei endet in einem Element, oder ein Element verspricht mehr Bytes, als übrig sind</translation>
    </message>
    <message>
        <source>is not a DICOM file: neither &apos;DICM&apos; nor an element stands where it should</source>
        <translation>ist keine DICOM-Datei: weder „DICM“ noch ein Element steht, wo es stehen sollte</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind</source>
        <translation>Gib der Datei die Endung ihrer Art</translation>
    </message>
    <message>
        <source>is a single slice, which makes no volume</source>
        <translation>ist eine einzelne Schicht, die kein Volumen ergibt</translation>
    </message>
    <message>
        <source>its slices do not lie above each other on one grid</source>
        <translation>die Schichten liegen nicht auf einem Raster übereinander</translation>
    </message>
    <message>
        <source>its slices are not evenly spaced; some moved by %1 mm</source>
        <translation>die Schichten liegen nicht gleich weit auseinander; manche wurden um %1 mm verschoben</translation>
    </message>
    <message>
        <source>Give all slices of the series, or have another program resample it evenly</source>
        <translation>Öffne alle Schichten der Serie oder lass ein anderes Programm sie gleichmäßig machen</translation>
    </message>
    <message>
        <source>Give the slices of one series, of one orientation and size</source>
        <translation>Öffne die Schichten einer Serie, einer Ausrichtung und Größe</translation>
    </message>
    <message>
        <source>none of its segments has a pixel</source>
        <translation>keines der Segmente hat ein Pixel</translation>
    </message>
    <message>
        <source>its contours enclose nothing; left out</source>
        <translation>die Konturen umschließen nichts; ausgelassen</translation>
    </message>
    <message>
        <source>has no contour; left out</source>
        <translation>hat keine Kontur; ausgelassen</translation>
    </message>
    <message>
        <source>holds points or open lines only; left out</source>
        <translation>enthält nur Punkte oder offene Linien; ausgelassen</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>das XML ist fehlerhaft: %1</translation>
    </message>
    <message>
        <source>Save the scene again in 3D Slicer</source>
        <translation>Speichere die Szene noch einmal in 3D Slicer</translation>
    </message>
    <message>
        <source>it is XML, but no 3D Slicer scene: there is no &lt;MRML&gt;</source>
        <translation>ist XML, aber keine Szene von 3D Slicer: es gibt kein &lt;MRML&gt;</translation>
    </message>
    <message>
        <source>Choose the .mrml file that 3D Slicer saved</source>
        <translation>Wähle die .mrml-Datei, die 3D Slicer gespeichert hat</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>Save the fiducials again in 3D Slicer</source>
        <translation>Speichere die Marken noch einmal in 3D Slicer</translation>
    </message>
    <message>
        <source>the scene has no saved views to tour</source>
        <translation>die Szene hat keine gespeicherten Ansichten für eine Tour</translation>
    </message>
    <message>
        <source>the scene has one saved view alone: there is no way to go</source>
        <translation>die Szene hat nur eine gespeicherte Ansicht: es gibt keinen Weg</translation>
    </message>
    <message>
        <source>rests of %1 seconds leave no time to move in a film of %2</source>
        <translation>bei Pausen von %1 Sekunden bleibt in einem Film von %2 keine Zeit für Bewegung</translation>
    </message>
    <message>
        <source>Make the rests shorter or the film longer</source>
        <translation>Mache die Pausen kürzer oder den Film länger</translation>
    </message>
    <message>
        <source>frames of %1 pixels are none for a film</source>
        <translation>Bilder von %1 Pixeln taugen nicht für einen Film</translation>
    </message>
    <message>
        <source>Choose a size of which both sides have 16 to 4320 pixels</source>
        <translation>Wähle eine Größe, bei der beide Seiten 16 bis 4320 Pixel haben</translation>
    </message>
    <message>
        <source>the ffmpeg that is installed has no encoder for MP4 films</source>
        <translation>das installierte ffmpeg hat keinen Encoder für MP4-Filme</translation>
    </message>
    <message>
        <source>Install an ffmpeg with libx264, or write an animated WebP or GIF</source>
        <translation>Installiere ein ffmpeg mit libx264 oder schreibe ein bewegtes WebP oder GIF</translation>
    </message>
    <message>
        <source>the film cannot be made: %1</source>
        <translation>der Film kann nicht gemacht werden: %1</translation>
    </message>
    <message>
        <source>Make it smaller, or of another kind</source>
        <translation>Mache ihn kleiner oder von anderer Art</translation>
    </message>
    <message>
        <source>the part of the program for pictures of this kind cannot be loaded: %1</source>
        <translation>der Teil des Programms für Bilder dieser Art lässt sich nicht laden: %1</translation>
    </message>
    <message>
        <source>modelling was cancelled</source>
        <translation>das Modellieren wurde abgebrochen</translation>
    </message>
    <message>
        <source>the graphics driver gives no OpenGL context to draw with</source>
        <translation>der Grafiktreiber gibt keinen OpenGL-Kontext zum Zeichnen</translation>
    </message>
    <message>
        <source>Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>Aktualisiere den Grafiktreiber oder setze LIBGL_ALWAYS_SOFTWARE=1</translation>
    </message>
    <message>
        <source>does not begin like a NIfTI file</source>
        <translation>beginnt nicht wie eine NIfTI-Datei</translation>
    </message>
    <message>
        <source>Export it as NIfTI again, or give the file the extension of its kind</source>
        <translation>Exportiere sie noch einmal als NIfTI oder gib der Datei die Endung ihrer Art</translation>
    </message>
    <message>
        <source>%1 of %2 left/right names contradict the frame %3 that the files give; %4</source>
        <translation>%1 von %2 Namen mit Seite widersprechen dem Koordinatensystem %3, das die Dateien nennen; %4</translation>
    </message>
    <message>
        <source>front and back are right: if the files are mirrored, choose %1</source>
        <translation>vorn und hinten stimmen: sind die Dateien gespiegelt, wähle %1</translation>
    </message>
    <message>
        <source>front and back are swapped too: choose %1</source>
        <translation>auch vorn und hinten sind vertauscht: wähle %1</translation>
    </message>
    <message>
        <source>if left and right are swapped, choose %1 where front and back are swapped too, else %2</source>
        <translation>sind links und rechts vertauscht, wähle %1, wo auch vorn und hinten vertauscht sind, sonst %2</translation>
    </message>
    <message>
        <source>Give the file one of these endings</source>
        <translation>Gib der Datei eine dieser Endungen</translation>
    </message>
    <message>
        <source>the sheet would have more than 20000 pixels on a side</source>
        <translation>das Blatt hätte mehr als 20000 Pixel auf einer Seite</translation>
    </message>
    <message>
        <source>its atoms lie too far apart for a lattice between them</source>
        <translation>seine Atome liegen zu weit auseinander für ein Gitter dazwischen</translation>
    </message>
    <message>
        <source>it has more than %1 atoms</source>
        <translation>es hat mehr als %1 Atome</translation>
    </message>
    <message>
        <source>Find the pockets of fewer chains at a time</source>
        <translation>Suche die Taschen von weniger Ketten auf einmal</translation>
    </message>
    <message>
        <source>its atoms lie closer together than those of matter do</source>
        <translation>seine Atome liegen dichter beieinander als die von Materie</translation>
    </message>
    <message>
        <source>Repair the file</source>
        <translation>Repariere die Datei</translation>
    </message>
    <message>
        <source>the large probe must be larger than the small one</source>
        <translation>die große Kugel muss größer sein als die kleine</translation>
    </message>
    <message>
        <source>panel %1</source>
        <translation>Bildfeld %1</translation>
    </message>
    <message>
        <source>panel %1, an inset of %2</source>
        <translation>Bildfeld %1, ein Ausschnitt von %2</translation>
    </message>
    <message>
        <source>letters and legend</source>
        <translation>Buchstaben und Legende</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is set in %2 pt, and letters smaller than %3 pt are refused</source>
        <translation>„%1“ steht in %2 pt, und Buchstaben unter %3 pt werden abgelehnt</translation>
    </message>
    <message>
        <source>Make &quot;points&quot; %1 or more, or &quot;least_points&quot; %2</source>
        <translation>Setze „points“ auf %1 oder mehr oder „least_points“ auf %2</translation>
    </message>
    <message>
        <source>it reaches over the page&apos;s edge or into the legend</source>
        <translation>es reicht über den Rand der Seite oder in die Legende</translation>
    </message>
    <message>
        <source>Move it, make it smaller or the page larger</source>
        <translation>Verschiebe oder verkleinere es, oder vergrößere die Seite</translation>
    </message>
    <message>
        <source>it is narrower or lower than 10 mm</source>
        <translation>es ist schmaler oder niedriger als 10 mm</translation>
    </message>
    <message>
        <source>Make the page larger, or take fewer columns or rows</source>
        <translation>Vergrößere die Seite, oder nimm weniger Spalten oder Zeilen</translation>
    </message>
    <message>
        <source>the part that it shows reaches over the edge of panel %1</source>
        <translation>der Teil, den es zeigt, reicht über den Rand von Bildfeld %1</translation>
    </message>
    <message>
        <source>Move the part, or make it smaller</source>
        <translation>Verschiebe den Teil, oder verkleinere ihn</translation>
    </message>
    <message>
        <source>it spans more columns than there are</source>
        <translation>es geht über mehr Spalten, als es gibt</translation>
    </message>
    <message>
        <source>Give the grid more columns</source>
        <translation>Gib dem Raster mehr Spalten</translation>
    </message>
    <message>
        <source>a legend tells colours, and ink alone has none</source>
        <translation>eine Legende erklärt Farben, und Tinte allein hat keine</translation>
    </message>
    <message>
        <source>it does not lie in the figure&apos;s folder or below it</source>
        <translation>sie liegt weder im Ordner der Abbildung noch darunter</translation>
    </message>
    <message>
        <source>Put the figure&apos;s file beside its scenes</source>
        <translation>Lege die Datei der Abbildung neben ihre Szenen</translation>
    </message>
    <message>
        <source>the scene has never been saved</source>
        <translation>die Szene ist nie gesichert worden</translation>
    </message>
    <message>
        <source>Save it first, so that the figure&apos;s file can name it</source>
        <translation>Sichere sie zuerst, damit die Datei der Abbildung sie nennen kann</translation>
    </message>
    <message>
        <source>Leave one of both out</source>
        <translation>Lass eins von beiden weg</translation>
    </message>
    <message>
        <source>Take fewer pixels to the inch, or a smaller sheet</source>
        <translation>Nimm weniger Pixel je Zoll oder ein kleineres Blatt</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>es gibt keinen Ordner %1</translation>
    </message>
    <message>
        <source>names say that z does not lead to the head: turn the files</source>
        <translation>Namen sagen, dass z nicht zum Kopf führt: Drehen Sie die Dateien</translation>
    </message>
    <message>
        <source>names of front and back contradict the frame %1; if the files are mirrored, choose %2</source>
        <translation>Namen mit vorn und hinten widersprechen dem Koordinatensystem %1; sind die Dateien gespiegelt, wählen Sie %2</translation>
    </message>
    <message>
        <source>surfaces whose files do not say their frame lie beside the others, whether they are read as LPS or as RAS; %1 was assumed</source>
        <translation>Flächen, deren Dateien ihr Koordinatensystem nicht nennen, liegen neben den anderen, ob als LPS oder als RAS gelesen; %1 wurde angenommen</translation>
    </message>
    <message>
        <source>scenes of 3D Slicer beside it disagree about its coordinates; none of them was followed</source>
        <translation>Szenen von 3D Slicer daneben sind sich über die Koordinaten uneinig; keiner wurde gefolgt</translation>
    </message>
    <message>
        <source>%1 of %2 structures are not as large as their names say: &quot;%3&quot; is %4 mm large, and such structures are %5 to %6 mm; %7</source>
        <translation>%1 von %2 Strukturen sind nicht so groß, wie ihre Namen sagen: „%3“ ist %4 mm groß, und solche Strukturen sind %5 bis %6 mm groß; %7</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 mm large, and such structures are %3 to %4 mm; %5</source>
        <translation>„%1“ ist %2 mm groß, und solche Strukturen sind %3 bis %4 mm groß; %5</translation>
    </message>
    <message>
        <source>no usual unit would make it right</source>
        <translation>keine übliche Einheit würde es richtig machen</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 mm</source>
        <translation>es wäre richtig, wenn die Einheit der Datei %1 mm wäre</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 or %2 mm</source>
        <translation>es wäre richtig, wenn die Einheit der Datei %1 oder %2 mm wäre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is flat: it has no extent in a direction</source>
        <translation>„%1“ ist flach: In einer Richtung hat es keine Ausdehnung</translation>
    </message>
    <message>
        <source>&quot;%1&quot; beside it gives none of its labels a name that is understood</source>
        <translation>„%1“ daneben gibt keinem seiner Labels einen Namen, der verstanden wird</translation>
    </message>
    <message>
        <source>holds %1 label volumes of one place, as points in time; structures of all of them lie over each other</source>
        <translation>enthält %1 Labelvolumen eines Ortes, etwa Zeitpunkte; die Strukturen aller liegen übereinander</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units; the sform was taken</source>
        <translation>sform und qform legen es an verschiedene Orte, bis zu %1 seiner Einheiten auseinander; die sform wurde genommen</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units and with left and right swapped; the sform was taken</source>
        <translation>sform und qform legen es an verschiedene Orte, bis zu %1 seiner Einheiten auseinander und mit links und rechts vertauscht; die sform wurde genommen</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as the file says</source>
        <translation>ist auf einer Schicht gezeichnet; %1 mm dick gemacht, wie die Datei sagt</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as slices of other structures are</source>
        <translation>ist auf einer Schicht gezeichnet; %1 mm dick gemacht, wie Schichten anderer Strukturen es sind</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, which nothing tells</source>
        <translation>ist auf einer Schicht gezeichnet; %1 mm dick gemacht, was nichts sagt</translation>
    </message>
    <message>
        <source>is of another patient than the files before it; left out</source>
        <translation>gehört zu einem anderen Patienten als die Dateien davor; weggelassen</translation>
    </message>
    <message>
        <source>files of one patient lie in different frames of reference: nothing says that what is laid over each other fits</source>
        <translation>Dateien eines Patienten liegen in verschiedenen Bezugssystemen: Nichts sagt, dass zusammenpasst, was übereinanderliegt</translation>
    </message>
    <message>
        <source>it is of another patient than the other files now</source>
        <translation>sie gehört jetzt zu einem anderen Patienten als die übrigen Dateien</translation>
    </message>
    <message>
        <source>it lies more than 100 km from the origin</source>
        <translation>er liegt mehr als 100 km vom Ursprung entfernt</translation>
    </message>
    <message>
        <source>Check the unit of its coordinates</source>
        <translation>Prüfen Sie die Einheit der Koordinaten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across: an implausible size, check the unit</source>
        <translation>„%1“ misst %2: eine unwahrscheinliche Größe, prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 other is as unlikely: an implausible size, check the unit</source>
        <translation>„%1“ misst %2, und %3 weitere Struktur ist ebenso unwahrscheinlich: prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 others are as unlikely: an implausible size, check the unit</source>
        <translation>„%1“ misst %2, und %3 weitere sind ebenso unwahrscheinlich: prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>eye or target lies more than 100,000 km away</source>
        <translation>Auge oder Ziel liegt mehr als 100.000 km entfernt</translation>
    </message>
    <message>
        <source>the height is too small or too large for where eye and target lie</source>
        <translation>die Höhe ist zu klein oder zu groß für die Lage von Auge und Ziel</translation>
    </message>
    <message>
        <source>weak vote: %1 of %2 left/right names</source>
        <translation>schwache Abstimmung: %1 von %2 Namen mit links/rechts</translation>
    </message>
    <message>
        <source>names of front and back alone</source>
        <translation>allein Namen mit vorn und hinten</translation>
    </message>
    <message>
        <source>laid over surfaces of the same names: %1 within 2 mm</source>
        <translation>über Flächen gleichen Namens gelegt: %1 innerhalb von 2 mm</translation>
    </message>
    <message>
        <source>fits in with the other surfaces</source>
        <translation>passt zu den anderen Flächen</translation>
    </message>
    <message>
        <source>confirmed by hand</source>
        <translation>von Hand bestätigt</translation>
    </message>
    <message>
        <source>mirrored by hand</source>
        <translation>von Hand gespiegelt</translation>
    </message>
    <message>
        <source>turned by hand</source>
        <translation>von Hand gedreht</translation>
    </message>
    <message>
        <source>%1; sizes are not those of what is named</source>
        <translation>%1; die Größen sind nicht die des Benannten</translation>
    </message>
    <message>
        <source>the program held %1 bytes for %2×%3 pixels of the picture, which is not what they take</source>
        <translation>das Programm hatte %1 Bytes für %2×%3 Pixel des Bildes, was nicht das ist, was sie brauchen</translation>
    </message>
    <message>
        <source>Save the scene and start the program again</source>
        <translation>Speichern Sie die Szene und starten Sie das Programm neu</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;: %2</source>
        <translation>Struktur „%1“: %2</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;: %2</source>
        <translation>Gruppe „%1“: %2</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;: %2</source>
        <translation>Ansicht „%1“: %2</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;: %2</source>
        <translation>Beschriftung „%1“: %2</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;: %2</source>
        <translation>Scan „%1“: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;</source>
        <translation>Struktur „%1“</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;</source>
        <translation>Gruppe „%1“</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;</source>
        <translation>Ansicht „%1“</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;</source>
        <translation>Beschriftung „%1“</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;</source>
        <translation>Scan „%1“</translation>
    </message>
    <message>
        <source>%1; it was cut there</source>
        <translation>%1; dort wurde gekürzt</translation>
    </message>
    <message>
        <source>%1; it was left out</source>
        <translation>%1; es wurde weggelassen</translation>
    </message>
    <message>
        <source>%1; they became signs for unknown letters</source>
        <translation>%1; sie wurden zu Zeichen für Unbekanntes</translation>
    </message>
    <message>
        <source>%1; the rest was left out</source>
        <translation>%1; der Rest wurde weggelassen</translation>
    </message>
    <message>
        <source>%1; the section was left out</source>
        <translation>%1; der Schnitt wurde weggelassen</translation>
    </message>
    <message>
        <source>%1; the atoms were left out</source>
        <translation>%1; die Atome wurden weggelassen</translation>
    </message>
    <message>
        <source>%1; what is in it went to the group above</source>
        <translation>%1; was darin ist, kam in die Gruppe darüber</translation>
    </message>
    <message>
        <source>the name is longer than %1 bytes</source>
        <translation>der Name ist länger als %1 Byte</translation>
    </message>
    <message>
        <source>the text is longer than %1 bytes</source>
        <translation>der Text ist länger als %1 Byte</translation>
    </message>
    <message>
        <source>a text is longer than %1 bytes</source>
        <translation>ein Text ist länger als %1 Byte</translation>
    </message>
    <message>
        <source>its credit is longer than %1 bytes</source>
        <translation>die Angabe zur Herkunft ist länger als %1 Byte</translation>
    </message>
    <message>
        <source>%1 is longer than %2 bytes</source>
        <translation>%1 ist länger als %2 Byte</translation>
    </message>
    <message>
        <source>the name has bytes that are no letters in UTF-8</source>
        <translation>der Name enthält Bytes, die in UTF-8 keine Zeichen sind</translation>
    </message>
    <message>
        <source>%1 has bytes that are no letters in UTF-8</source>
        <translation>%1 enthält Bytes, die in UTF-8 keine Zeichen sind</translation>
    </message>
    <message>
        <source>%1 is in more than %2 languages</source>
        <translation>%1 steht in mehr als %2 Sprachen</translation>
    </message>
    <message>
        <source>%1 is in a language that has no name</source>
        <translation>%1 steht in einer Sprache ohne Namen</translation>
    </message>
    <message>
        <source>%1 is no finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>der Wert von %1 liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>the time is out of range</source>
        <translation>die Zeit liegt außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>it lies more than %1 groups deep</source>
        <translation>sie liegt mehr als %1 Gruppen tief</translation>
    </message>
    <message>
        <source>it is on a triangle that no structure of the scene has</source>
        <translation>sie zeigt auf ein Dreieck, das keine Struktur der Szene hat</translation>
    </message>
    <message>
        <source>what is painted on it is of another surface</source>
        <translation>was darauf gemalt ist, gehört zu einer anderen Oberfläche</translation>
    </message>
    <message>
        <source>an atom lies nowhere, or there are too many</source>
        <translation>ein Atom liegt nirgends, oder es sind zu viele</translation>
    </message>
    <message>
        <source>a scene holds no more than %1 %2, and these would be %3</source>
        <translation>eine Szene fasst höchstens %1 %2, und dies wären %3</translation>
    </message>
    <message>
        <source>structures and groups</source>
        <translation>Strukturen und Gruppen</translation>
    </message>
    <message>
        <source>Take fewer of them into one scene</source>
        <translation>Nimm weniger davon in eine Szene</translation>
    </message>
    <message>
        <source>Change it so that a scene file can keep it</source>
        <translation>Ändere es so, dass eine Szenendatei es aufnehmen kann</translation>
    </message>
    <message>
        <source>Undo what brought it into the scene, and save again</source>
        <translation>Mach rückgängig, was es in die Szene brachte, und speichere erneut</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file</source>
        <translation>die Szene ist zu groß für eine Szenendatei</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file: %1</source>
        <translation>die Szene ist zu groß für eine Szenendatei: %1</translation>
    </message>
    <message>
        <source>Save fewer views, or fewer structures in one scene</source>
        <translation>Speichere weniger Ansichten oder weniger Strukturen in einer Szene</translation>
    </message>
    <message>
        <source>Put fewer structures or scans into one scene</source>
        <translation>Nimm weniger Strukturen oder Scans in eine Szene</translation>
    </message>
    <message>
        <source>something in it is at fault and not in the scene; it would be lost</source>
        <translation>etwas darin ist fehlerhaft und nicht in der Szene; es ginge verloren</translation>
    </message>
    <message>
        <source>something in it is at fault: %1</source>
        <translation>etwas darin ist fehlerhaft: %1</translation>
    </message>
    <message>
        <source>Open it by itself and save it under another name</source>
        <translation>Öffne sie für sich und speichere sie unter anderem Namen</translation>
    </message>
    <message>
        <source>something in it is at fault and was left out (%1); the file stays as it is, and the scene can only be saved under another name</source>
        <translation>etwas darin ist fehlerhaft und wurde weggelassen (%1); die Datei bleibt, wie sie ist, und die Szene kann nur unter anderem Namen gespeichert werden</translation>
    </message>
    <message>
        <source>a newer version of the program has written it (schema %1, known here: %2); what is unknown is not shown, and it can only be saved under another name, as schema %3</source>
        <translation>eine neuere Version des Programms hat sie geschrieben (Schema %1, hier bekannt: %2); Unbekanntes wird nicht gezeigt, und sie kann nur unter anderem Namen gespeichert werden, als Schema %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; (%2): %3</source>
        <translation>„%1“ (%2): %3</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected here</source>
        <translation>hier wird eine Zahl von %1 bis %2 erwartet</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected here</source>
        <translation>hier wird eine ganze Zahl von %1 bis %2 erwartet</translation>
    </message>
    <message>
        <source>a text is expected here</source>
        <translation>hier wird ein Text erwartet</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>hier wird eine Zahl erwartet</translation>
    </message>
    <message>
        <source>true or false is expected here</source>
        <translation>hier wird true oder false erwartet</translation>
    </message>
    <message>
        <source>a list is expected here</source>
        <translation>hier wird eine Liste erwartet</translation>
    </message>
    <message>
        <source>an object is expected here</source>
        <translation>hier wird ein Objekt erwartet</translation>
    </message>
    <message>
        <source>a line of at most %1 bytes is expected here</source>
        <translation>hier wird eine Zeile von höchstens %1 Byte erwartet</translation>
    </message>
    <message>
        <source>a colour as &quot;#rrggbb&quot; is expected here</source>
        <translation>hier wird eine Farbe als „#rrggbb“ erwartet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or another word of this format is expected here</source>
        <translation>hier wird „%1“ oder ein anderes Wort dieses Formats erwartet</translation>
    </message>
    <message>
        <source>the file holds no such mesh</source>
        <translation>die Datei enthält kein solches Netz</translation>
    </message>
    <message>
        <source>it is no mesh of this format</source>
        <translation>es ist kein Netz dieses Formats</translation>
    </message>
    <message>
        <source>%1; the structure stays as an empty row</source>
        <translation>%1; die Struktur bleibt als leere Zeile</translation>
    </message>
    <message>
        <source>the file holds no such paint</source>
        <translation>die Datei enthält keine solche Bemalung</translation>
    </message>
    <message>
        <source>it does not begin like what is painted on a mesh</source>
        <translation>es beginnt nicht wie das, was auf ein Netz gemalt ist</translation>
    </message>
    <message>
        <source>it does not begin like the voxels of a scan</source>
        <translation>es beginnt nicht wie die Voxel eines Scans</translation>
    </message>
    <message>
        <source>its unit is stated (%1) and was followed</source>
        <translation>ihre Einheit ist angegeben (%1) und wurde befolgt</translation>
    </message>
    <message>
        <source>%1 lies on the other side than its name says</source>
        <translation>%1 liegt auf der anderen Seite, als der Name sagt</translation>
    </message>
    <message>
        <source>%1 lie on the other side than their names say</source>
        <translation>%1 liegen auf der anderen Seite, als ihre Namen sagen</translation>
    </message>
    <message>
        <source>molecules are drawn with 1 Å as 1 mm, ten million times as large as &quot;%1&quot; beside them; no scale bar holds for both, so open them apart</source>
        <translation>Moleküle sind mit 1 Å als 1 mm gezeichnet, zehn Millionen Mal so groß wie „%1“ neben ihnen; kein Maßstab gilt für beide, öffne sie also getrennt</translation>
    </message>
    <message>
        <source>SlicerRT&apos;s segmentations are RAS</source>
        <translation>Segmentierungen von SlicerRT sind RAS</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, which are not as many as it has; it was placed as if its origin were its own</source>
        <translation>sagt, dass sie die Voxel %1 eines Referenzbildes enthält, und das sind nicht so viele, wie sie hat; sie wurde so platziert, als wäre der Ursprung ihr eigener</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, and an offset in it, as files with an origin of their own do; it was placed by its origin alone</source>
        <translation>nennt die Voxel %1 eines Referenzbildes und eine Verschiebung darin, wie es Dateien mit eigenem Ursprung tun; sie wurde allein nach ihrem Ursprung platziert</translation>
    </message>
    <message>
        <source>the files are of %1 patients: %2</source>
        <translation>die Dateien sind von %1 Patienten: %2</translation>
    </message>
    <message>
        <source>the files are of %1 studies, and nothing says that they are of one patient: %2</source>
        <translation>die Dateien sind von %1 Studien, und nichts sagt, dass sie von einem Patienten sind: %2</translation>
    </message>
    <message>
        <source>Give the files of one patient, or put them together on purpose</source>
        <translation>Gib die Dateien eines Patienten an, oder füge sie mit Absicht zusammen</translation>
    </message>
    <message>
        <source>it came from more than %1 studies</source>
        <translation>sie kam aus mehr als %1 Studien</translation>
    </message>
    <message>
        <source>what was there already is read as %1 now: %2</source>
        <translation>was schon da war, wird jetzt als %1 gelesen: %2</translation>
    </message>
    <message>
        <source>left and right of what was there already are certain now: %1</source>
        <translation>links und rechts sind bei dem, was schon da war, jetzt sicher: %1</translation>
    </message>
    <message>
        <source>is a scan rather than a label volume: %1</source>
        <translation>ist ein Scan und kein Labelvolumen: %1</translation>
    </message>
    <message>
        <source>Give a threshold that makes a structure of it, or choose the segmentation that was made of it</source>
        <translation>Gib einen Schwellenwert an, der eine Struktur daraus macht, oder wähle die Segmentierung, die davon gemacht wurde</translation>
    </message>
    <message>
        <source>Structures come from a DICOM segmentation or RT structure set, from label maps and meshes made of the images, or from a threshold</source>
        <translation>Strukturen kommen aus einer Segmentierung oder einem RT-Strukturset von DICOM, aus Labelkarten und Netzen, die aus den Bildern entstanden, oder von einem Schwellenwert</translation>
    </message>
    <message>
        <source>Name one of the scene&apos;s saved views</source>
        <translation>Nenne eine der gespeicherten Ansichten der Szene</translation>
    </message>
    <message>
        <source>Change it in the figure&apos;s file</source>
        <translation>Ändere es in der Datei der Abbildung</translation>
    </message>
    <message>
        <source>a comparison sheet is a pdf, svg, png or tiff file</source>
        <translation>ein Vergleichsblatt ist eine pdf-, svg-, png- oder tiff-Datei</translation>
    </message>
    <message>
        <source>a figure is a pdf, svg, png or tiff file</source>
        <translation>eine Abbildung ist eine pdf-, svg-, png- oder tiff-Datei</translation>
    </message>
    <message>
        <source>a depth of 1 bit leaves black and white alone, and the figure has tones</source>
        <translation>eine Tiefe von 1 Bit lässt nur Schwarz und Weiß, und die Abbildung hat Töne</translation>
    </message>
    <message>
        <source>Let the figure be black and white, or take 8 bits</source>
        <translation>Mache die Abbildung schwarz-weiß oder nimm 8 Bit</translation>
    </message>
    <message>
        <source>names of sides in this folder contradict the frame of the others, %1; it was taken, and is not certain here</source>
        <translation>Namen von Seiten in diesem Ordner widersprechen dem Koordinatensystem der anderen, %1; es wurde genommen und ist hier nicht sicher</translation>
    </message>
    <message>
        <source>the files of this folder are read as %1, unlike others: %2</source>
        <translation>die Dateien dieses Ordners werden anders als andere als %1 gelesen: %2</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image; its origin was taken to be that image&apos;s</source>
        <translation>sagt, dass sie die Voxel %1 eines Referenzbildes enthält; ihr Ursprung wurde als der dieses Bildes genommen</translation>
    </message>
    <message>
        <source>Save it as a scene file, and name it with its ending .sline</source>
        <translation>Speichere es als Szenendatei und benenne sie mit ihrer Endung .sline</translation>
    </message>
    <message>
        <source>words and numbers of no anatomy, maybe a person&apos;s, left out of names: %1</source>
        <translation>in Namen weggelassene Wörter und Zahlen, die nicht zur Anatomie gehören, aber zu einer Person gehören können; betroffene Namen: %1</translation>
    </message>
    <message>
        <source>there is no such member in the file</source>
        <translation>die Datei enthält keinen solchen Teil</translation>
    </message>
    <message>
        <source>the graphics driver has lost what it had drawn</source>
        <translation>der Grafiktreiber hat verloren, was er gezeichnet hatte</translation>
    </message>
    <message>
        <source>the graphics driver has no memory left for the picture</source>
        <translation>der Grafiktreiber hat keinen Speicher mehr für das Bild</translation>
    </message>
    <message>
        <source>the names of the files tell of %1 bodies: %2</source>
        <translation>die Namen der Dateien sprechen von %1 Körpern: %2</translation>
    </message>
    <message>
        <source>another file of this name is not as it was read; name its folder if that one is meant</source>
        <translation>eine andere Datei dieses Namens ist nicht so, wie sie gelesen wurde; nennen Sie deren Ordner, wenn jene gemeint ist</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 large now and was %3: its file may have another unit</source>
        <translation>„%1“ ist jetzt %2 groß und war %3: die Datei kann eine andere Einheit haben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies %2 away from where it was: it may be another body&apos;s, or mirrored</source>
        <translation>„%1“ liegt %2 von der früheren Stelle entfernt: es kann von einem anderen Körper oder gespiegelt sein</translation>
    </message>
</context>
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
    <message>
        <source>Opens a window of its own, whatever the preferences say of files from outside.</source>
        <translation>Öffnet ein eigenes Fenster, was auch immer die Einstellungen zu Dateien von außen sagen.</translation>
    </message>
</context>
<context>
    <name>sline::render::ExportFormat</name>
    <message>
        <source>Vectors for Inkscape, Illustrator and print: lines and hatching as smooth paths, hidden ones removed, a named group for each structure</source>
        <translation>Vektoren für Inkscape, Illustrator und Druck: Linien und Schraffur als glatte Pfade, Verdecktes entfernt, eine benannte Gruppe je Struktur</translation>
    </message>
    <message>
        <source>A picture made of pixels for screens, documents and print: sRGB, grey or pure ink, 8 or 16 bits, transparent where asked for</source>
        <translation>Ein Bild aus Pixeln für Bildschirm, Dokumente und Druck: sRGB, grau oder reine Tinte, 8 oder 16 Bit, auf Wunsch durchsichtig</translation>
    </message>
    <message>
        <source>The same for printers and journals, with its colour profile</source>
        <translation>Dasselbe für Druckereien und Zeitschriften, mit Farbprofil</translation>
    </message>
    <message>
        <source>A picture made of pixels where files must be small; on white</source>
        <translation>Ein Bild aus Pixeln, wo Dateien klein sein müssen; auf Weiß</translation>
    </message>
    <message>
        <source>A picture in linear light, as halves with alpha multiplied in, for compositing</source>
        <translation>Ein Bild in linearem Licht, halbe Genauigkeit, mit eingerechnetem Alpha, zum Zusammensetzen</translation>
    </message>
    <message>
        <source>Surfaces for Blender, PowerPoint, web pages and headsets: groups, names and colours, annotations, cameras of the saved views</source>
        <translation>Oberflächen für Blender, PowerPoint, Webseiten und Brillen: Gruppen, Namen und Farben, Beschriftungen, Kameras der gespeicherten Ansichten</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4-Film</translation>
    </message>
    <message>
        <source>A film for slides and web pages, where the program ffmpeg is installed</source>
        <translation>Ein Film für Folien und Webseiten, wo das Programm ffmpeg eingerichtet ist</translation>
    </message>
    <message>
        <source>Animated WebP</source>
        <translation>Bewegtes WebP</translation>
    </message>
    <message>
        <source>A film that browsers show as a picture</source>
        <translation>Ein Film, den Browser als Bild zeigen</translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation>Bewegtes GIF</translation>
    </message>
    <message>
        <source>A film that every program shows, of at most 255 colours: small ones</source>
        <translation>Ein Film, den jedes Programm zeigt, mit höchstens 255 Farben: für kleine</translation>
    </message>
    <message>
        <source>Frames of a film</source>
        <translation>Einzelbilder eines Films</translation>
    </message>
    <message>
        <source>A new folder of numbered PNG pictures, for programs that cut films</source>
        <translation>Ein neuer Ordner nummerierter PNG-Bilder, für Schnittprogramme</translation>
    </message>
    <message>
        <source>Anki deck</source>
        <translation>Anki-Stapel</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>TIFF picture</source>
        <translation>TIFF-Bild</translation>
    </message>
    <message>
        <source>JPEG picture</source>
        <translation>JPEG-Bild</translation>
    </message>
    <message>
        <source>EXR picture</source>
        <translation>EXR-Bild</translation>
    </message>
    <message>
        <source>WebP picture</source>
        <translation>WebP-Bild</translation>
    </message>
    <message>
        <source>A picture for web pages, smaller than PNG and as exact: 8 bits in colour</source>
        <translation>Ein Bild für Webseiten, kleiner als PNG und ebenso genau: 8 Bit in Farbe</translation>
    </message>
    <message>
        <source>JPEG 2000 picture</source>
        <translation>JPEG-2000-Bild</translation>
    </message>
    <message>
        <source>A picture for archives that ask for it, exact: 8 or 16 bits</source>
        <translation>Ein Bild für Archive, die es verlangen, genau: 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>GLB surfaces (glTF)</source>
        <translation>GLB-Flächen (glTF)</translation>
    </message>
    <message>
        <source>PowerPoint slides</source>
        <translation>PowerPoint-Folien</translation>
    </message>
    <message>
        <source>A slide for each saved view with its title, text and notes: labels are text boxes and lines that can be edited there, over the drawing</source>
        <translation>Eine Folie für jede gespeicherte Ansicht mit Titel, Text und Notizen: Beschriftungen sind Textfelder und Linien über der Zeichnung, die sich dort bearbeiten lassen</translation>
    </message>
    <message>
        <source>The same vectors on a page of their own, or a sheet with title, legend and numbered labels, a page to test oneself and its key; of all saved views with contents and an index</source>
        <translation>Dieselben Vektoren auf einer eigenen Seite, oder ein Blatt mit Titel, Legende und nummerierten Beschriftungen, einer Seite zum Selbsttest und der Lösung; von allen gespeicherten Ansichten mit Inhalt und Verzeichnis</translation>
    </message>
    <message>
        <source>Cards that ask for the labels of the picture, or of all saved views: a package for Anki (.apkg), or text and pictures in a ZIP (.zip) or a new folder</source>
        <translation>Karten, die nach den Beschriftungen des Bildes oder aller gespeicherten Ansichten fragen: ein Paket für Anki (.apkg) oder Text und Bilder in einem ZIP (.zip) oder einem neuen Ordner</translation>
    </message>
    <message>
        <source>For students (HTML page)</source>
        <translation>Für Studierende (HTML-Seite)</translation>
    </message>
    <message>
        <source>One file for any browser, also offline and on telephones: the scene to turn, with its tree, labels, saved views as a tour, and a quiz</source>
        <translation>Eine Datei für jeden Browser, auch ohne Netz und auf Telefonen: die Szene zum Drehen, mit ihrem Baum, Beschriftungen, gespeicherten Ansichten als Rundgang und einem Quiz</translation>
    </message>
    <message>
        <source>For students (web site)</source>
        <translation>Für Studierende (Webseite)</translation>
    </message>
    <message>
        <source>The same page as a new folder of files for a web server, most of which are the same for every scene; browsers do not open it from a disk</source>
        <translation>Dieselbe Seite als neuer Ordner mit Dateien für einen Webserver, von denen die meisten für jede Szene gleich sind; von der Festplatte öffnen Browser sie nicht</translation>
    </message>
    <message>
        <source>Moodle questions</source>
        <translation>Moodle-Fragen</translation>
    </message>
    <message>
        <source>Questions with pictures, made of the labels, as XML for a question bank: markers to be put in place, names to be typed or chosen</source>
        <translation>Fragen mit Bildern aus den Beschriftungen, als XML für eine Fragensammlung: Marken, die an ihren Ort kommen, Namen zum Tippen oder Auswählen</translation>
    </message>
    <message>
        <source>QTI questions</source>
        <translation>QTI-Fragen</translation>
    </message>
    <message>
        <source>The same for other question banks and examination systems, as a package of QTI 2.1</source>
        <translation>Dasselbe für andere Fragensammlungen und Prüfungssysteme, als Paket von QTI 2.1</translation>
    </message>
    <message>
        <source>H5P questions</source>
        <translation>H5P-Fragen</translation>
    </message>
    <message>
        <source>The same as content for H5P, to be played where its content types are installed</source>
        <translation>Dasselbe als Inhalt für H5P, gespielt, wo dessen Inhaltstypen installiert sind</translation>
    </message>
    <message>
        <source>SCORM 1.2 package</source>
        <translation>SCORM-1.2-Paket</translation>
    </message>
    <message>
        <source>The page for students in a package that tells a learning system each answer and the score, by the standard that most systems know</source>
        <translation>Die Seite für Lernende in einem Paket, das einer Lernplattform jede Antwort und das Ergebnis meldet, nach dem Standard, den die meisten kennen</translation>
    </message>
    <message>
        <source>SCORM 2004 package</source>
        <translation>SCORM-2004-Paket</translation>
    </message>
    <message>
        <source>The same by SCORM 2004, 4th edition</source>
        <translation>Dasselbe nach SCORM 2004, 4. Ausgabe</translation>
    </message>
    <message>
        <source>cmi5 package</source>
        <translation>cmi5-Paket</translation>
    </message>
    <message>
        <source>The same by cmi5, for systems with a learning record store</source>
        <translation>Dasselbe nach cmi5, für Plattformen mit einem Learning Record Store</translation>
    </message>
</context>
<context>
    <name>sline::render::ExportOption</name>
    <message>
        <source>&amp;Deck</source>
        <translation>&amp;Stapel</translation>
    </message>
    <message>
        <source>Its name in Anki; else the view&apos;s name</source>
        <translation>Sein Name in Anki; sonst der Name der Ansicht</translation>
    </message>
    <message>
        <source>Once around</source>
        <translation>Einmal herum</translation>
    </message>
    <message>
        <source>From view to view</source>
        <translation>Von Ansicht zu Ansicht</translation>
    </message>
    <message>
        <source>Γ from 0 to 5</source>
        <translation>Γ von 0 bis 5</translation>
    </message>
    <message>
        <source>Len&amp;gth</source>
        <translation>&amp;Dauer</translation>
    </message>
    <message>
        <source>Of the whole film</source>
        <translation>Des ganzen Films</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Pictures a secon&amp;d</source>
        <translation>Bi&amp;lder je Sekunde</translation>
    </message>
    <message>
        <source>More are smoother, and more to draw</source>
        <translation>Mehr sind flüssiger, und mehr zu zeichnen</translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation>Höhe des Films</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>Be&amp;wegung</translation>
    </message>
    <message>
        <source>What moves in the film</source>
        <translation>Was sich im Film bewegt</translation>
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
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nummern</translation>
    </message>
    <message>
        <source>Blank lines, for a test</source>
        <translation>Leere Zeilen, zum Abfragen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>Beschri&amp;ftungen</translation>
    </message>
    <message>
        <source>How the scene&apos;s labels stand in the picture</source>
        <translation>Wie die Beschriftungen der Szene im Bild stehen</translation>
    </message>
    <message>
        <source>Le&amp;tters</source>
        <translation>Bu&amp;chstaben</translation>
    </message>
    <message>
        <source>How large the letters of labels are on paper</source>
        <translation>Wie groß die Buchstaben der Beschriftung auf Papier sind</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message>
        <source>&amp;Right and left</source>
        <translation>&amp;Rechts und links</translation>
    </message>
    <message>
        <source>R and L, and the body&apos;s other directions</source>
        <translation>R und L und die anderen Richtungen des Körpers</translation>
    </message>
    <message>
        <source>&amp;Name of the view</source>
        <translation>&amp;Name der Ansicht</translation>
    </message>
    <message>
        <source>“Anterior view”, or the saved view&apos;s name</source>
        <translation>„Ansicht von vorn“ oder der Name der gespeicherten Ansicht</translation>
    </message>
    <message>
        <source>S&amp;cale bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Wie lang ein Zentimeter ist</translation>
    </message>
    <message>
        <source>S&amp;ections</source>
        <translation>Schn&amp;itte</translation>
    </message>
    <message>
        <source>What sections have taken away</source>
        <translation>Was Schnitte weggenommen haben</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Urheber</translation>
    </message>
    <message>
        <source>Written into the file, which says of nobody who made it where this is empty</source>
        <translation>Kommt in die Datei; bleibt es leer, sagt sie von niemandem, wer sie gemacht hat</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Rechte</translation>
    </message>
    <message>
        <source>Whose it is or what others may do with it, as in “CC BY 4.0”</source>
        <translation>Wem es gehört oder was andere damit dürfen, wie „CC BY 4.0“</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>Hinter&amp;grund</translation>
    </message>
    <message>
        <source>What lies behind the drawing</source>
        <translation>Was hinter der Zeichnung liegt</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Of texts and numbers; where a label has no text in it, the scene&apos;s own</source>
        <translation>Der Texte und Zahlen; wo eine Beschriftung in ihr keinen Text hat, die der Szene</translation>
    </message>
    <message>
        <source>Black in&amp;k alone</source>
        <translation>Nur schwar&amp;ze Tinte</translation>
    </message>
    <message>
        <source>For print without tones: each pixel is ink or paper; what is shaded is hatched instead</source>
        <translation>Für Druck ohne Töne: Jedes Pixel ist Tinte oder Papier; statt schattiert wird schraffiert</translation>
    </message>
    <message>
        <source>The figure alone</source>
        <translation>Nur die Abbildung</translation>
    </message>
    <message>
        <source>With title and legend</source>
        <translation>Mit Titel und Legende</translation>
    </message>
    <message>
        <source>For teaching, with self-test</source>
        <translation>Für Unterricht, mit Selbsttest</translation>
    </message>
    <message>
        <source>For a patient</source>
        <translation>Für Patienten</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>US Letter</source>
        <translation>US Letter</translation>
    </message>
    <message>
        <source>Paper of the sheet</source>
        <translation>Papier des Blatts</translation>
    </message>
    <message>
        <source>Of sheets alone</source>
        <translation>Nur von Blättern</translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation>T&amp;itel</translation>
    </message>
    <message>
        <source>At the head of a sheet</source>
        <translation>Oben auf einem Blatt</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Of a sheet for a patient; each line is a paragraph</source>
        <translation>Eines Blatts für Patienten; jede Zeile ist ein Absatz</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>Breiter als hoch</translation>
    </message>
    <message>
        <source>Shee&amp;t</source>
        <translation>&amp;Blatt</translation>
    </message>
    <message>
        <source>The page around the figure, of a paper of its own</source>
        <translation>Die Seite um die Abbildung, auf eigenem Papier</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source>Of each colour; 16 bits for work that follows</source>
        <translation>Jeder Farbe; 16 Bit zum Weiterarbeiten</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>Without colours, with a grey profile</source>
        <translation>Ohne Farben, mit Grauprofil</translation>
    </message>
    <message>
        <source>1280 × 720, HD</source>
        <translation>1280 × 720, HD</translation>
    </message>
    <message>
        <source>1920 × 1080, Full HD</source>
        <translation>1920 × 1080, Full HD</translation>
    </message>
    <message>
        <source>1080 × 1080, square</source>
        <translation>1080 × 1080, quadratisch</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Eine andere Größe</translation>
    </message>
    <message>
        <source>The page&apos;s shape</source>
        <translation>Die Form der Seite</translation>
    </message>
    <message>
        <source>Width and height in pixels</source>
        <translation>Breite und Höhe in Pixeln</translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation>Breite des Films</translation>
    </message>
    <message>
        <source>Of another size</source>
        <translation>Bei einer anderen Größe</translation>
    </message>
    <message>
        <source>Of another size, or of the page&apos;s shape</source>
        <translation>Bei einer anderen Größe oder der Form der Seite</translation>
    </message>
    <message>
        <source>On sheets alone</source>
        <translation>Nur auf Blättern</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle Strukturen</translation>
    </message>
    <message>
        <source>Those with a label</source>
        <translation>Die mit Beschriftung</translation>
    </message>
    <message>
        <source>Those in focus</source>
        <translation>Die im Fokus</translation>
    </message>
    <message>
        <source>Colours and names, in the picture&apos;s corner or on the sheet</source>
        <translation>Farben und Namen, in der Ecke des Bildes oder auf dem Blatt</translation>
    </message>
    <message>
        <source>Size of the film</source>
        <translation>Größe des Films</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Γ over s&amp;urfaces</source>
        <translation>Γ über &amp;Flächen</translation>
    </message>
    <message>
        <source>By what Γ varies, and how the drawing changes along it</source>
        <translation>Wonach Γ sich ändert, und wie sich die Zeichnung dabei wandelt</translation>
    </message>
    <message>
        <source>Su&amp;btitle file</source>
        <translation>&amp;Untertiteldatei</translation>
    </message>
    <message>
        <source>What the views say as a WebVTT file beside the film, for players and web pages</source>
        <translation>Was die Ansichten sagen, als WebVTT-Datei neben dem Film, für Abspielprogramme und Webseiten</translation>
    </message>
    <message>
        <source>Text of the &amp;view</source>
        <translation>Te&amp;xt der Ansicht</translation>
    </message>
    <message>
        <source>Title and text of a saved view at the picture&apos;s foot, where it says any; in films as a subtitle</source>
        <translation>Titel und Text einer gespeicherten Ansicht am Fuß des Bildes, wo sie welche hat; in Filmen als Untertitel</translation>
    </message>
    <message>
        <source>16 : 9</source>
        <translation>16 : 9</translation>
    </message>
    <message>
        <source>4 : 3</source>
        <translation>4 : 3</translation>
    </message>
    <message>
        <source>Shape of slides</source>
        <translation>Form der Folien</translation>
    </message>
    <message>
        <source>Width and height of a slide</source>
        <translation>Breite und Höhe einer Folie</translation>
    </message>
    <message>
        <source>Labels by clicks</source>
        <translation>Beschriftung auf Klicks</translation>
    </message>
    <message>
        <source>Labels appear one by one, each with a click, in the scene&apos;s order</source>
        <translation>Beschriftungen erscheinen eine nach der anderen, jede auf einen Klick, in der Reihenfolge der Szene</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>After each slide one with numbers in place of its labels, and then the key</source>
        <translation>Nach jeder Folie eine mit Nummern an Stelle ihrer Beschriftungen, dann die Lösung</translation>
    </message>
    <message>
        <source>Which number is it?</source>
        <translation>Welche Nummer ist es?</translation>
    </message>
    <message>
        <source>A card for each name, which asks for its number in the picture</source>
        <translation>Eine Karte für jeden Namen, die nach seiner Nummer im Bild fragt</translation>
    </message>
    <message>
        <source>Which name is covered?</source>
        <translation>Welcher Name ist verdeckt?</translation>
    </message>
    <message>
        <source>A card for each label, which covers its name among the others</source>
        <translation>Eine Karte für jede Beschriftung, die ihren Namen zwischen den anderen verdeckt</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>Was ist das?</translation>
    </message>
    <message>
        <source>A card for each label, which marks the place and asks what it is</source>
        <translation>Eine Karte für jede Beschriftung, die die Stelle markiert und fragt, was es ist</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>What the picture shows, for who does not see it; where this is empty, the file says what is seen in the picture, and “off” leaves it out</source>
        <translation>Was das Bild zeigt, für wen es nicht zu sehen ist; ist das Feld leer, sagt die Datei, was im Bild zu sehen ist, und „off“ lässt es weg</translation>
    </message>
    <message>
        <source>Beside surfaces alone</source>
        <translation>Nur bei Flächen</translation>
    </message>
    <message>
        <source>In a line</source>
        <translation>In einer Zeile</translation>
    </message>
    <message>
        <source>On a page of their own</source>
        <translation>Auf einer eigenen Seite</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Nirgends</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Whose work the surfaces are and under what terms</source>
        <translation>Wessen Werk die Flächen sind und unter welchen Bedingungen</translation>
    </message>
    <message>
        <source>All with a label</source>
        <translation>Allem Beschrifteten</translation>
    </message>
    <message>
        <source>Test asks for</source>
        <translation>Test fragt nach</translation>
    </message>
    <message>
        <source>The fewer, the easier</source>
        <translation>Je weniger, desto leichter</translation>
    </message>
    <message>
        <source>Of these alone</source>
        <translation>Nur davon</translation>
    </message>
    <message>
        <source>Names of structures or groups, with commas; empty: of all</source>
        <translation>Namen von Strukturen oder Gruppen, mit Kommas; leer: von allen</translation>
    </message>
    <message>
        <source>&amp;Callouts, too</source>
        <translation>Auch Te&amp;xtfelder</translation>
    </message>
    <message>
        <source>Callouts explain; only labels name what can be asked for</source>
        <translation>Textfelder erklären; nur Beschriftungen benennen, wonach man fragen kann</translation>
    </message>
    <message>
        <source>After each test</source>
        <translation>Nach jedem Test</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Am Ende</translation>
    </message>
    <message>
        <source>Word bank</source>
        <translation>Wörterliste</translation>
    </message>
    <message>
        <source>The self-test has the answers below, in another order</source>
        <translation>Unter dem Selbsttest stehen die Antworten in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Where the answers stand, each test&apos;s on a page of its own</source>
        <translation>Wo die Antworten stehen, die jedes Tests auf einer eigenen Seite</translation>
    </message>
    <message>
        <source>Beside names and labels</source>
        <translation>Neben den Namen</translation>
    </message>
    <message>
        <source>Nothing else, no names</source>
        <translation>Nichts sonst, keine Namen</translation>
    </message>
    <message>
        <source>&amp;Quiz</source>
        <translation>&amp;Quiz</translation>
    </message>
    <message>
        <source>What the page asks; alone, no name of a structure is in its file</source>
        <translation>Was die Seite fragt; allein steht kein Name einer Struktur in der Datei</translation>
    </message>
    <message>
        <source>Where is it?</source>
        <translation>Wo ist es?</translation>
    </message>
    <message>
        <source>The quiz names something, and it is clicked</source>
        <translation>Das Quiz nennt etwas, das angeklickt wird</translation>
    </message>
    <message>
        <source>What is it? Typed</source>
        <translation>Was ist es? Getippt</translation>
    </message>
    <message>
        <source>The quiz lights something up, and its name is typed</source>
        <translation>Das Quiz hebt etwas hervor, dessen Name getippt wird</translation>
    </message>
    <message>
        <source>What is it? One of four</source>
        <translation>Was ist es? Eins von vieren</translation>
    </message>
    <message>
        <source>The other three names are of neighbours and of the same kind</source>
        <translation>Die anderen drei Namen sind von Nachbarn und von derselben Art</translation>
    </message>
    <message>
        <source>Order along a path</source>
        <translation>Reihenfolge entlang eines Wegs</translation>
    </message>
    <message>
        <source>Where a group is a chain of vessels, the quiz asks for their order</source>
        <translation>Wo eine Gruppe eine Kette von Gefäßen ist, fragt das Quiz nach ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>Labels to their places</source>
        <translation>Beschriftungen an ihren Ort</translation>
    </message>
    <message>
        <source>Labels are dragged to what they name</source>
        <translation>Beschriftungen werden zu dem gezogen, was sie benennen</translation>
    </message>
    <message>
        <source>Answers count</source>
        <translation>Antworten zählen</translation>
    </message>
    <message>
        <source>The page tells how many were right</source>
        <translation>Die Seite sagt, wie viele richtig waren</translation>
    </message>
    <message>
        <source>No turning meanwhile</source>
        <translation>Dabei kein Drehen</translation>
    </message>
    <message>
        <source>While something is asked, the anatomy cannot be turned</source>
        <translation>Während gefragt wird, lässt sich die Anatomie nicht drehen</translation>
    </message>
    <message>
        <source>No hiding meanwhile</source>
        <translation>Dabei kein Verbergen</translation>
    </message>
    <message>
        <source>While something is asked, nothing can be hidden and no Γ changed</source>
        <translation>Während gefragt wird, lässt sich nichts verbergen und kein Γ ändern</translation>
    </message>
    <message>
        <source>Title of the page</source>
        <translation>Titel der Seite</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Sprachen</translation>
    </message>
    <message>
        <source>As in “de, la”; empty: all in which there are names</source>
        <translation>Wie in „de, la“; leer: alle, in denen es Namen gibt</translation>
    </message>
    <message>
        <source>Triangles at most</source>
        <translation>Dreiecke höchstens</translation>
    </message>
    <message>
        <source>Fewer make a smaller file and a quicker page; 0: all there are</source>
        <translation>Weniger machen die Datei kleiner und die Seite schneller; 0: alle, die es gibt</translation>
    </message>
    <message>
        <source>Surfaces off by</source>
        <translation>Flächen weichen ab um</translation>
    </message>
    <message>
        <source>Surfaces that may be a little off need fewer triangles; 0: exact</source>
        <translation>Flächen, die ein wenig abweichen dürfen, brauchen weniger Dreiecke; 0: genau</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Bestanden ab</translation>
    </message>
    <message>
        <source>The share of right answers that the learning system takes as passed</source>
        <translation>Der Anteil richtiger Antworten, den die Lernplattform als bestanden wertet</translation>
    </message>
    <message>
        <source>Else what the group that holds all is called, or where there is none the file</source>
        <translation>Sonst, wie die Gruppe heißt, die alles enthält, oder ohne eine solche die Datei</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Pixels to the inch of PNG and TIFF; journals ask for 300 or 600, and for up to 1200 where there are lines alone</source>
        <translation>Pixel je Zoll von PNG und TIFF; Zeitschriften verlangen 300 oder 600, für reine Strichzeichnungen bis 1200</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>1 bit, ink or paper</source>
        <translation>1 Bit, Tinte oder Papier</translation>
    </message>
    <message>
        <source>1 bit is for black and white figures, as printers take line art</source>
        <translation>1 Bit ist für Abbildungen in Schwarz-Weiß, wie Druckereien Strichzeichnungen nehmen</translation>
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
        <translation>Hin&amp;tergrund</translation>
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
        <source>Take Γ from the group above again</source>
        <translation>Γ wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Show or &amp;Hide</source>
        <translation>Ein- oder &amp;ausblenden</translation>
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
        <source>Show &amp;All</source>
        <translation>A&amp;lle zeigen</translation>
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
        <translation>En&amp;tfernen</translation>
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
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Turn around this place from now on</source>
        <translation>Von nun an um diese Stelle drehen</translation>
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
        <source>Its rights do not let it be written to</source>
        <translation>Ihre Rechte erlauben kein Schreiben</translation>
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
    <message>
        <source>Cut away</source>
        <translation>Weggeschnitten</translation>
    </message>
    <message>
        <source>Orientation cube</source>
        <translation>Orientierungswürfel</translation>
    </message>
    <message>
        <source>The body&apos;s sides in the corner of the picture; a click looks from there</source>
        <translation>Die Seiten des Körpers in der Ecke des Bildes; ein Klick blickt von dort</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>True at the depth of what the picture turns around</source>
        <translation>Gilt in der Tiefe dessen, worum sich das Bild dreht</translation>
    </message>
    <message>
        <source>Names under the mouse</source>
        <translation>Namen unter der Maus</translation>
    </message>
    <message>
        <source>What a structure is called where the mouse rests</source>
        <translation>Wie eine Struktur heißt, auf der die Maus ruht</translation>
    </message>
    <message>
        <source>Time that a picture takes</source>
        <translation>Zeit, die ein Bild braucht</translation>
    </message>
    <message>
        <source>In milliseconds, in the corner of the picture</source>
        <translation>In Millisekunden, in der Ecke des Bildes</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Mouse buttons as in</source>
        <translation>Maustasten wie in</translation>
    </message>
    <message>
        <source>Which buttons and keys turn, move and zoom the picture; H shows them</source>
        <translation>Welche Tasten das Bild drehen, verschieben und zoomen; H zeigt sie</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>3D Slicer</source>
        <translation>3D Slicer</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Short flights between views</source>
        <translation>Kurze Flüge zwischen Ansichten</translation>
    </message>
    <message>
        <source>Off: the picture changes at once</source>
        <translation>Aus: das Bild wechselt sofort</translation>
    </message>
    <message>
        <source>Sagittal section</source>
        <translation>Sagittalschnitt</translation>
    </message>
    <message>
        <source>Coronal section</source>
        <translation>Koronalschnitt</translation>
    </message>
    <message>
        <source>Axial section</source>
        <translation>Axialschnitt</translation>
    </message>
    <message>
        <source>Oblique section</source>
        <translation>Schräger Schnitt</translation>
    </message>
    <message>
        <source>Whole scene</source>
        <translation>Ganze Szene</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Hide Others</source>
        <translation>Andere ausblenden</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ erben</translation>
    </message>
    <message>
        <source>Inherit Colour</source>
        <translation>Farbe erben</translation>
    </message>
    <message>
        <source>Inherit Opacity</source>
        <translation>Deckkraft erben</translation>
    </message>
    <message>
        <source>Inherit All</source>
        <translation>Alles erben</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>%1, its own</source>
        <translation>%1, eigenes</translation>
    </message>
    <message>
        <source>%1, inherited</source>
        <translation>%1, geerbt</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>deckend</translation>
    </message>
    <message>
        <source>tint</source>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>veil</source>
        <translation>Schleier</translation>
    </message>
    <message>
        <source>simplified from %1 triangles, at most %2 mm off</source>
        <translation>vereinfacht aus %1 Dreiecken, höchstens %2 mm daneben</translation>
    </message>
    <message>
        <source>smoothed in %1 steps, at most %2 mm off</source>
        <translation>geglättet in %1 Schritten, höchstens %2 mm daneben</translation>
    </message>
    <message>
        <source>refined in %1 steps</source>
        <translation>verfeinert in %1 Schritten</translation>
    </message>
    <message>
        <source>%1 faces mended</source>
        <translation>%1 Flächen ausgebessert</translation>
    </message>
    <message>
        <source>moved as its scene says</source>
        <translation>verschoben, wie ihre Szene sagt</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>made by the program</source>
        <translation>vom Programm erzeugt</translation>
    </message>
    <message>
        <source>Part of the file</source>
        <translation>Teil der Datei</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Γ</source>
        <translation>Γ</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Between the lines</source>
        <translation>Zwischen den Linien</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linienstärke</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>by the group above</source>
        <translation>durch die Gruppe darüber</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>none: the surface has holes</source>
        <translation>keines: die Oberfläche hat Löcher</translation>
    </message>
    <message>
        <source>%1, of %2 closed surfaces</source>
        <translation>%1, von %2 geschlossenen Oberflächen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Ziehen mit der Mitteltaste</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Ziehen mit rechts</translation>
    </message>
    <message>
        <source>Zoom: upwards is nearer</source>
        <translation>Zoomen: nach oben ist näher</translation>
    </message>
    <message>
        <source>Roll the picture around its middle</source>
        <translation>Das Bild um seine Mitte rollen</translation>
    </message>
    <message>
        <source>Two fingers on a touchpad</source>
        <translation>Zwei Finger auf dem Touchpad</translation>
    </message>
    <message>
        <source>Move the picture; pinch to zoom</source>
        <translation>Das Bild verschieben; spreizen zum Zoomen</translation>
    </message>
    <message>
        <source>Select what is seen there</source>
        <translation>Wählen, was dort zu sehen ist</translation>
    </message>
    <message>
        <source>Add to the selection, or take away from it</source>
        <translation>Zur Auswahl hinzufügen oder daraus nehmen</translation>
    </message>
    <message>
        <source>Select the next structure behind; after the last the first</source>
        <translation>Die nächste Struktur dahinter wählen; nach der letzten die erste</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Drag the arrow of a section</source>
        <translation>Den Pfeil eines Schnitts ziehen</translation>
    </message>
    <message>
        <source>Move the plane; with Ctrl in whole steps</source>
        <translation>Die Ebene verschieben; mit Strg in ganzen Schritten</translation>
    </message>
    <message>
        <source>Click on the arrow&apos;s head</source>
        <translation>Klick auf die Pfeilspitze</translation>
    </message>
    <message>
        <source>Keep the other side of the section</source>
        <translation>Die andere Seite des Schnitts behalten</translation>
    </message>
    <message>
        <source>Drag a ring of a section</source>
        <translation>Einen Ring eines Schnitts ziehen</translation>
    </message>
    <message>
        <source>Tilt the plane; with Ctrl in steps of 15°</source>
        <translation>Die Ebene kippen; mit Strg in Schritten von 15°</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Turn by %1°</source>
        <translation>Um %1° drehen</translation>
    </message>
    <message>
        <source>Plus, minus</source>
        <translation>Plus, Minus</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>&amp;Inherit</source>
        <translation>&amp;Erben</translation>
    </message>
    <message>
        <source>&amp;Over the Picture</source>
        <translation>&amp;Über dem Bild</translation>
    </message>
    <message>
        <source>Re&amp;load from Source</source>
        <translation>Von der &amp;Quelle neu laden</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>&amp;Geist</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>The selected structures as outlines under a veil</source>
        <translation>Die gewählten Strukturen als Umrisse unter einem Schleier</translation>
    </message>
    <message>
        <source>Co&amp;lour…</source>
        <translation>Far&amp;be …</translation>
    </message>
    <message>
        <source>Another colour for the selected</source>
        <translation>Eine andere Farbe für die gewählten</translation>
    </message>
    <message>
        <source>Inherit &amp;Γ</source>
        <translation>&amp;Γ erben</translation>
    </message>
    <message>
        <source>Inherit &amp;Colour</source>
        <translation>&amp;Farbe erben</translation>
    </message>
    <message>
        <source>Take the colour from the group above again</source>
        <translation>Die Farbe wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Inherit &amp;Opacity</source>
        <translation>&amp;Deckkraft erben</translation>
    </message>
    <message>
        <source>Take the opacity from the group above again</source>
        <translation>Die Deckkraft wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Inherit &amp;All</source>
        <translation>&amp;Alles erben</translation>
    </message>
    <message>
        <source>Take the whole look from the group above again</source>
        <translation>Das ganze Aussehen wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Show the selected structures and nothing else; again: everything</source>
        <translation>Nur die gewählten Strukturen zeigen; noch einmal: alles</translation>
    </message>
    <message>
        <source>Hide &amp;Others</source>
        <translation>An&amp;dere ausblenden</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Hide all but the selected structures</source>
        <translation>Alle außer den gewählten Strukturen ausblenden</translation>
    </message>
    <message>
        <source>&amp;Zoom To</source>
        <translation>Heran&amp;zoomen</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Bring the selected structures into the picture, and turn around them</source>
        <translation>Die gewählten Strukturen ins Bild bringen und um sie drehen</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Another name</source>
        <translation>Ein anderer Name</translation>
    </message>
    <message>
        <source>Ne&amp;w Group</source>
        <translation>&amp;Neue Gruppe</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>An empty group</source>
        <translation>Eine leere Gruppe</translation>
    </message>
    <message>
        <source>Grou&amp;p</source>
        <translation>Gru&amp;ppieren</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>The selected structures in a group of their own</source>
        <translation>Die gewählten Strukturen in einer eigenen Gruppe</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Gruppe auflö&amp;sen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Dissolve the selected groups; what is in them keeps its look</source>
        <translation>Die gewählten Gruppen auflösen; was in ihnen ist, behält sein Aussehen</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>Spe&amp;rren</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>What is locked keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Was gesperrt ist, behält Aussehen, Namen und Platz und lässt sich im Bild nicht anklicken</translation>
    </message>
    <message>
        <source>Alt+Return</source>
        <translation>Alt+Return</translation>
    </message>
    <message>
        <source>Where it came from, how large it is, how it is drawn</source>
        <translation>Woher sie kommt, wie groß sie ist, wie sie gezeichnet wird</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Cut across the line of sight</source>
        <translation>Quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>&amp;Orientation Cube</source>
        <translation>&amp;Orientierungswürfel</translation>
    </message>
    <message>
        <source>Scale &amp;Bar</source>
        <translation>&amp;Maßstab</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Wie lang ein Zentimeter ist</translation>
    </message>
    <message>
        <source>&amp;Names under the Mouse</source>
        <translation>&amp;Namen unter der Maus</translation>
    </message>
    <message>
        <source>Picture &amp;Time</source>
        <translation>Bild&amp;zeit</translation>
    </message>
    <message>
        <source>How long the last picture took to draw</source>
        <translation>Wie lange das Zeichnen des letzten Bildes gedauert hat</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Bring the selected structures into the picture</source>
        <translation>Die gewählten Strukturen ins Bild bringen</translation>
    </message>
    <message>
        <source>Drag over eyes or locks</source>
        <translation>Über Augen oder Schlösser ziehen</translation>
    </message>
    <message>
        <source>Set them all alike</source>
        <translation>Alle gleich setzen</translation>
    </message>
    <message>
        <source>Alt + click on an eye</source>
        <translation>Alt + Klick auf ein Auge</translation>
    </message>
    <message>
        <source>Show this and nothing else; again: everything</source>
        <translation>Nur dies zeigen; noch einmal: alles</translation>
    </message>
    <message>
        <source>Middle click on Γ or colour</source>
        <translation>Mittelklick auf Γ oder Farbe</translation>
    </message>
    <message>
        <source>Take it from the group above again</source>
        <translation>Es wieder von der Gruppe darüber nehmen</translation>
    </message>
    <message>
        <source>Drag rows</source>
        <translation>Zeilen ziehen</translation>
    </message>
    <message>
        <source>Put them elsewhere, or into another group</source>
        <translation>An eine andere Stelle oder in eine andere Gruppe legen</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Doppelklick auf einen Namen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>New Group</source>
        <translation>Neue Gruppe</translation>
    </message>
    <message>
        <source>How wide lines are, times the usual; 0 draws none</source>
        <translation>Wie breit Linien sind, im Verhältnis zum Üblichen; 0 zeichnet keine</translation>
    </message>
    <message>
        <source>Hatching: strokes</source>
        <translation>Schraffur: Striche</translation>
    </message>
    <message>
        <source>How many strokes hatching has, times the usual; its tone stays</source>
        <translation>Wie viele Striche die Schraffur hat, im Verhältnis zum Üblichen; ihr Tonwert bleibt</translation>
    </message>
    <message>
        <source>Hatching: tone</source>
        <translation>Schraffur: Tonwert</translation>
    </message>
    <message>
        <source>How dark hatching is, times the usual, by the width of its strokes</source>
        <translation>Wie dunkel die Schraffur ist, im Verhältnis zum Üblichen, durch die Breite ihrer Striche</translation>
    </message>
    <message>
        <source>How much of what lies behind the colour is hidden; lines stay</source>
        <translation>Wie viel von dem verdeckt ist, was hinter der Farbe liegt; Linien bleiben</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the shaded surface and of washes</source>
        <translation>Der schattierten Oberfläche und der Lasuren</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>Of lines and hatching; else black, or light on a dark background</source>
        <translation>Für Linien und Schraffur; sonst schwarz, oder hell auf dunklem Hintergrund</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Always show import options</source>
        <translation>Importoptionen immer zeigen</translation>
    </message>
    <message>
        <source>Before meshes are opened: units, smoothing and what is left out</source>
        <translation>Bevor Netze geöffnet werden: Einheiten, Glättung und was weggelassen wird</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>See and change what an import would do, before it is done</source>
        <translation>Sehen und ändern, was ein Import tun würde, bevor er geschieht</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>The same for all meshes in a folder</source>
        <translation>Dasselbe für alle Netze in einem Ordner</translation>
    </message>
    <message>
        <source>Import Op&amp;tions…</source>
        <translation>Impor&amp;toptionen …</translation>
    </message>
    <message>
        <source>Import what is open once more, with other units, smoothing or choice</source>
        <translation>Das Offene noch einmal importieren, mit anderen Einheiten, anderer Glättung oder Auswahl</translation>
    </message>
    <message>
        <source>Proper&amp;ties…</source>
        <translation>Eigens&amp;chaften …</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>&amp;Quer zum Blick</translation>
    </message>
    <message>
        <source>I&amp;mport Folder…</source>
        <translation>O&amp;rdner importieren …</translation>
    </message>
    <message>
        <source>A&amp;dd View</source>
        <translation>An&amp;sicht hinzufügen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Save what you see as a view: camera, what is shown, Γ, colours and sections</source>
        <translation>Was du siehst als Ansicht speichern: Kamera, was gezeigt wird, Γ, Farben und Schnitte</translation>
    </message>
    <message>
        <source>Presen&amp;t</source>
        <translation>Vor&amp;führen</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>The saved views one after the other on the whole screen</source>
        <translation>Die gespeicherten Ansichten nacheinander auf dem ganzen Bildschirm</translation>
    </message>
    <message>
        <source>The scene&apos;s own</source>
        <translation>Die der Szene</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nummern</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>Beschri&amp;ftungen</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message numerus="yes">
        <source>%n structures, seen as in the window.</source>
        <translation>
            <numerusform>%n Struktur, gesehen wie im Fenster.</numerusform>
            <numerusform>%n Strukturen, gesehen wie im Fenster.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures as surfaces.</source>
        <translation>
            <numerusform>%n Struktur als Oberfläche.</numerusform>
            <numerusform>%n Strukturen als Oberflächen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No labels.</source>
        <translation>Keine Beschriftung.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels as numbers.</source>
        <translation>
            <numerusform>%n Beschriftung als Nummer.</numerusform>
            <numerusform>%n Beschriftungen als Nummern.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels as blank lines.</source>
        <translation>
            <numerusform>%n Beschriftung als leere Zeile.</numerusform>
            <numerusform>%n Beschriftungen als leere Zeilen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels in the scene&apos;s own language.</source>
        <translation>
            <numerusform>%n Beschriftung in der Sprache der Szene.</numerusform>
            <numerusform>%n Beschriftungen in der Sprache der Szene.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels, language: %1.</source>
        <translation>
            <numerusform>%n Beschriftung, Sprache: %1.</numerusform>
            <numerusform>%n Beschriftungen, Sprache: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, as lines and shapes of any sharpness.</source>
        <translation>%1, als Linien und Flächen, in jeder Größe scharf.</translation>
    </message>
    <message>
        <source>%1, %2 at %3 dpi.</source>
        <translation>%1, %2 bei %3 dpi.</translation>
    </message>
    <message>
        <source>Names of structures, groups and views are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Namen von Strukturen, Gruppen und Ansichten stehen in der Datei, wie die Szene sie hat. Keine Pfade, Benutzernamen, Daten oder Patientenangaben.</translation>
    </message>
    <message>
        <source>Nothing is in the file but what is seen: no paths, user names, dates or patient data.</source>
        <translation>In der Datei steht nur, was man sieht: keine Pfade, Benutzernamen, Daten oder Patientenangaben.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>No structure is shown: the picture would be empty.</source>
        <translation>Keine Struktur wird gezeigt: Das Bild wäre leer.</translation>
    </message>
    <message>
        <source>The view “%1” shows no structure: its picture would be empty.</source>
        <translation>Die Ansicht „%1“ zeigt keine Struktur: Ihr Bild wäre leer.</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>US Letter</source>
        <translation>US Letter</translation>
    </message>
    <message>
        <source>Slide 16:9</source>
        <translation>Folie 16:9</translation>
    </message>
    <message>
        <source>Journal column</source>
        <translation>Spalte einer Zeitschrift</translation>
    </message>
    <message>
        <source>A1 poster</source>
        <translation>Poster A1</translation>
    </message>
    <message>
        <source>Say what the file is to be called.</source>
        <translation>Sag, wie die Datei heißen soll.</translation>
    </message>
    <message>
        <source>The name is too long for a file: take a shorter one.</source>
        <translation>Der Name ist für eine Datei zu lang: Nimm einen kürzeren.</translation>
    </message>
    <message>
        <source>There is no folder “%1”: choose one that is there.</source>
        <translation>Es gibt keinen Ordner „%1“: Wähle einen, den es gibt.</translation>
    </message>
    <message>
        <source>“%1” is a file and no folder: choose a folder.</source>
        <translation>„%1“ ist eine Datei und kein Ordner: Wähle einen Ordner.</translation>
    </message>
    <message>
        <source>“%1” is a folder: give the file another name.</source>
        <translation>„%1“ ist ein Ordner: Gib der Datei einen anderen Namen.</translation>
    </message>
    <message>
        <source>You may not write to “%1”: choose another folder or name.</source>
        <translation>„%1“ darfst du nicht schreiben: Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write pictures, drawings and other files for print, teaching and other programs</source>
        <translation>Bilder, Zeichnungen und andere Dateien für Druck, Unterricht und andere Programme schreiben</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The picture on the clipboard, with its labels, for other programs</source>
        <translation>Das Bild in die Zwischenablage, mit seiner Beschriftung, für andere Programme</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>eine Stelle</translation>
    </message>
    <message>
        <source>nothing that is there</source>
        <translation>nichts Vorhandenes</translation>
    </message>
    <message>
        <source>Callout</source>
        <translation>Textfeld</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The scene’s own</source>
        <translation>Die der Szene</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>Labels show</source>
        <translation>Beschriftungen zeigen</translation>
    </message>
    <message>
        <source>Numbers are for a key beside the picture, blank lines for a test</source>
        <translation>Nummern sind für eine Legende neben dem Bild, leere Linien für einen Test</translation>
    </message>
    <message>
        <source>Blank lines</source>
        <translation>Leere Linien</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>What labels say, where they have words in that language; else the scene’s own</source>
        <translation>Was Beschriftungen sagen, wo sie Worte in dieser Sprache haben; sonst die der Szene</translation>
    </message>
    <message>
        <source>As the structures</source>
        <translation>Wie die Strukturen</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Größe der Buchstaben</translation>
    </message>
    <message>
        <source>As on paper, whatever the size of the picture</source>
        <translation>Wie auf Papier, gleich wie groß das Bild ist</translation>
    </message>
    <message>
        <source>S&amp;how as</source>
        <translation>&amp;Zeigen als</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>&amp;Beschriftung</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Click on a structure and type what it is called</source>
        <translation>Auf eine Struktur klicken und schreiben, wie sie heißt</translation>
    </message>
    <message>
        <source>&amp;Callout</source>
        <translation>Te&amp;xtfeld</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Click on a place and type a few lines, which stand in a frame</source>
        <translation>Auf eine Stelle klicken und einige Zeilen schreiben, die in einem Rahmen stehen</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Nadel</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>Click on a place to mark it; its text stands beside it</source>
        <translation>Auf eine Stelle klicken, um sie zu markieren; ihr Text steht daneben</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Maß</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Click on two places to measure between them</source>
        <translation>Auf zwei Stellen klicken, um dazwischen zu messen</translation>
    </message>
    <message>
        <source>Label the &amp;Selected</source>
        <translation>&amp;Ausgewähltes beschriften</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>The selected structures get labels with their names, where they are best seen</source>
        <translation>Die ausgewählten Strukturen werden mit ihren Namen beschriftet, wo sie am besten zu sehen sind</translation>
    </message>
    <message>
        <source>&amp;Edit Text</source>
        <translation>&amp;Text ändern</translation>
    </message>
    <message>
        <source>Type what the chosen label says (F2 in the picture)</source>
        <translation>Schreiben, was die gewählte Beschriftung sagt (F2 im Bild)</translation>
    </message>
    <message>
        <source>Dele&amp;te Label</source>
        <translation>Beschriftung lös&amp;chen</translation>
    </message>
    <message>
        <source>Take the chosen label away (Del in the picture)</source>
        <translation>Die gewählte Beschriftung wegnehmen (Entf im Bild)</translation>
    </message>
    <message>
        <source>Author and rights are in the file as you typed them.</source>
        <translation>Urheber und Rechte stehen in der Datei, wie du sie eingetippt hast.</translation>
    </message>
    <message>
        <source>the view&apos;s name</source>
        <translation>der Name der Ansicht</translation>
    </message>
    <message>
        <source>the scale bar</source>
        <translation>der Maßstab</translation>
    </message>
    <message>
        <source>the legend</source>
        <translation>die Legende</translation>
    </message>
    <message>
        <source>what sections have taken away</source>
        <translation>was Schnitte weggenommen haben</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room: %1.</source>
        <translation>
            <numerusform>%n Beschriftung fand keinen Platz: %1.</numerusform>
            <numerusform>%n Beschriftungen fanden keinen Platz: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are left out, as nothing is drawn there: %1.</source>
        <translation>
            <numerusform>%n Beschriftung fehlt, da dort nichts gezeichnet ist: %1.</numerusform>
            <numerusform>%n Beschriftungen fehlen, da dort nichts gezeichnet ist: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels point to places beside the picture: %1.</source>
        <translation>
            <numerusform>%n Beschriftung zeigt auf eine Stelle neben dem Bild: %1.</numerusform>
            <numerusform>%n Beschriftungen zeigen auf Stellen neben dem Bild: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels have no text in the language and stand in the scene&apos;s own: %1.</source>
        <translation>
            <numerusform>%n Beschriftung hat keinen Text in der Sprache und steht in der eigenen der Szene: %1.</numerusform>
            <numerusform>%n Beschriftungen haben keinen Text in der Sprache und stehen in der eigenen der Szene: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room and have no card: %1.</source>
        <translation>
            <numerusform>%n Beschriftung fand keinen Platz und hat keine Karte: %1.</numerusform>
            <numerusform>%n Beschriftungen fanden keinen Platz und haben keine Karte: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the picture&apos;s edge there is no room for: %1.</source>
        <translation>Am Rand des Bildes ist kein Platz für: %1.</translation>
    </message>
    <message>
        <source>R and L are left out: nobody knows the directions of what is drawn.</source>
        <translation>R und L fehlen: Niemand kennt die Richtungen dessen, was gezeichnet ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts are shortened: %1.</source>
        <translation>
            <numerusform>%n Text ist gekürzt: %1.</numerusform>
            <numerusform>%n Texte sind gekürzt: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections cut nothing in the file, which holds whole surfaces: %1.</source>
        <translation>
            <numerusform>%n Schnitt schneidet nichts in der Datei, denn sie enthält ganze Oberflächen: %1.</numerusform>
            <numerusform>%n Schnitte schneiden nichts in der Datei, denn sie enthält ganze Oberflächen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is transparent stands on white.</source>
        <translation>Was durchsichtig ist, steht auf Weiß.</translation>
    </message>
    <message>
        <source>This kind has fewer bits than were chosen.</source>
        <translation>Diese Art von Datei hat weniger Bits, als gewählt sind.</translation>
    </message>
    <message>
        <source>The film is %1 pixels large, as its sides are even numbers.</source>
        <translation>Der Film ist %1 Pixel groß, da seine Seiten gerade Zahlen sind.</translation>
    </message>
    <message>
        <source>The film takes %1 seconds, as it has whole pictures alone.</source>
        <translation>Der Film dauert %1 Sekunden, da er nur ganze Bilder hat.</translation>
    </message>
    <message>
        <source>Take a larger page, smaller letters, or numbers.</source>
        <translation>Nimm eine größere Seite, kleinere Buchstaben oder Nummern.</translation>
    </message>
    <message>
        <source>Show the structures, or hide the labels, too.</source>
        <translation>Zeige die Strukturen, oder blende die Beschriftungen mit aus.</translation>
    </message>
    <message>
        <source>Choose a view that shows them.</source>
        <translation>Wähle eine Ansicht, die sie zeigt.</translation>
    </message>
    <message>
        <source>Write them in the list of labels, or choose another language.</source>
        <translation>Schreibe sie in die Liste der Beschriftungen, oder wähle eine andere Sprache.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters.</source>
        <translation>Nimm eine größere Seite oder kleinere Buchstaben.</translation>
    </message>
    <message>
        <source>Say them when the files are imported.</source>
        <translation>Gib sie beim Importieren der Dateien an.</translation>
    </message>
    <message>
        <source>Write less, or take larger paper.</source>
        <translation>Schreibe weniger, oder nimm größeres Papier.</translation>
    </message>
    <message>
        <source>Export a picture or a drawing to show the cut.</source>
        <translation>Exportiere ein Bild oder eine Zeichnung, um den Schnitt zu zeigen.</translation>
    </message>
    <message>
        <source>Take PNG, TIFF, SVG or WebP to keep it transparent.</source>
        <translation>Nimm PNG, TIFF, SVG oder WebP, damit es durchsichtig bleibt.</translation>
    </message>
    <message>
        <source>Take PNG or TIFF for more.</source>
        <translation>Nimm PNG oder TIFF für mehr.</translation>
    </message>
    <message>
        <source>The text is for a patient&apos;s sheet: this one does not have it.</source>
        <translation>Der Text gehört auf ein Blatt für Patienten: dieses hat ihn nicht.</translation>
    </message>
    <message>
        <source>&amp;Print Proof…</source>
        <translation>Druck&amp;probe …</translation>
    </message>
    <message>
        <source>Find neighbours that a press without colours or some eyes cannot tell apart, and what would help</source>
        <translation>Findet Nachbarn, die ein Druck ohne Farben oder manche Augen nicht unterscheiden, und was helfen würde</translation>
    </message>
    <message>
        <source>Files from outside open in</source>
        <translation>Dateien von außen öffnen in</translation>
    </message>
    <message>
        <source>What a file manager or a command names while a window is open</source>
        <translation>Was eine Dateiverwaltung oder ein Befehl nennt, während ein Fenster offen ist</translation>
    </message>
    <message>
        <source>The open window</source>
        <translation>Das offene Fenster</translation>
    </message>
    <message>
        <source>A window of their own</source>
        <translation>Ein eigenes Fenster</translation>
    </message>
    <message>
        <source>Look of what is opened</source>
        <translation>Aussehen beim Öffnen</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Schlicht</translation>
    </message>
    <message>
        <source>Dra&amp;w as Plate</source>
        <translation>Als Tafel zeich&amp;nen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>What the scene is about in detail, seen from where it shows best, everything else as context</source>
        <translation>Worum es in der Szene geht, ausführlich und von dort gesehen, wo es sich am besten zeigt; alles andere als Umgebung</translation>
    </message>
    <message>
        <source>Another S&amp;ubject</source>
        <translation>Anderes The&amp;ma</translation>
    </message>
    <message>
        <source>A plate of what else the scene may be about; again for the next</source>
        <translation>Eine Tafel von etwas anderem, worum es in der Szene gehen kann; noch einmal für das nächste</translation>
    </message>
    <message>
        <source>lesion</source>
        <translation>Läsion</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>nerve</source>
        <translation>Nerv</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>the subject</source>
        <translation>das Thema</translation>
    </message>
    <message>
        <source>it comes to the subject</source>
        <translation>sie führt zum Thema</translation>
    </message>
    <message>
        <source>it is near the subject</source>
        <translation>sie ist nahe dem Thema</translation>
    </message>
    <message>
        <source>it lies outside and hides the subject</source>
        <translation>sie liegt außen und verdeckt das Thema</translation>
    </message>
    <message>
        <source>it is away from the subject</source>
        <translation>sie ist fern vom Thema</translation>
    </message>
    <message>
        <source>not drawn: more context would show it</source>
        <translation>nicht gezeichnet: Mehr Kontext würde es zeigen</translation>
    </message>
    <message>
        <source>in detail: it is the subject</source>
        <translation>im Detail: Es ist das Thema</translation>
    </message>
    <message>
        <source>solid and pale: the subject lies in it</source>
        <translation>deckend und blass: Das Thema liegt darin</translation>
    </message>
    <message>
        <source>outline: %1 in front of the subject</source>
        <translation>Umriss: %1 vor dem Thema</translation>
    </message>
    <message>
        <source>modelled: %1 that comes to the subject</source>
        <translation>modelliert: %1, führt zum Thema</translation>
    </message>
    <message>
        <source>solid: %1 near the subject</source>
        <translation>deckend: %1 nahe dem Thema</translation>
    </message>
    <message>
        <source>solid and pale: %1 away from the subject</source>
        <translation>deckend und blass: %1 fern vom Thema</translation>
    </message>
    <message>
        <source>lines: %1</source>
        <translation>Linien: %1</translation>
    </message>
    <message>
        <source>Ligands</source>
        <translation>Liganden</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Läsionen</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Vessels and nerves</source>
        <translation>Gefäße und Nerven</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>What lies in the organs</source>
        <translation>Was in den Organen liegt</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Line weight</source>
        <translation>Strichstärke und Druck</translation>
    </message>
    <message>
        <source>How much the pen&apos;s width tells light, depth and form; 0 is an even pen</source>
        <translation>Wie sehr die Breite der Feder Licht, Tiefe und Form zeigt; 0 ist eine gleichmäßige Feder</translation>
    </message>
    <message>
        <source>Line smoothing</source>
        <translation>Linienglättung</translation>
    </message>
    <message>
        <source>How far lines leave what turns back and forth, times the usual</source>
        <translation>Wie weit Linien verlassen, was hin und her geht, mal dem Üblichen</translation>
    </message>
    <message>
        <source>Shortest line</source>
        <translation>Kürzeste Linie</translation>
    </message>
    <message>
        <source>Shorter pieces of lines are left out; in 1/720 of the picture&apos;s height</source>
        <translation>Kürzere Linienstücke entfallen; in 1/720 der Bildhöhe</translation>
    </message>
    <message>
        <source>Line scale</source>
        <translation>Linienmaßstab</translation>
    </message>
    <message>
        <source>How large a form must be to get suggestive contours, times the usual; 0 draws all that were measured</source>
        <translation>Wie groß eine Form sein muss, um angedeutete Konturen zu bekommen, mal dem Üblichen; 0 zeichnet alle gemessenen</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>Lichthof</translation>
    </message>
    <message>
        <source>How many line widths before its outline lines behind stop</source>
        <translation>Wie viele Linienbreiten vor dem Umriss Linien dahinter enden</translation>
    </message>
    <message>
        <source>Pencil grain</source>
        <translation>Bleistiftkorn</translation>
    </message>
    <message>
        <source>How much the pen is a pencil on rough paper</source>
        <translation>Wie sehr die Feder ein Bleistift auf rauem Papier ist</translation>
    </message>
    <message>
        <source>Hidden outlines</source>
        <translation>Verdeckte Umrisse</translation>
    </message>
    <message>
        <source>How outlines are drawn where other structures hide them</source>
        <translation>Wie Umrisse gezeichnet werden, wo andere Strukturen sie verdecken</translation>
    </message>
    <message>
        <source>Not drawn</source>
        <translation>Nicht gezeichnet</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Other Sub&amp;jects…</source>
        <translation>&amp;Andere Themen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+J</source>
        <translation>Ctrl+Shift+J</translation>
    </message>
    <message>
        <source>Small plates of the next three subjects, to choose from</source>
        <translation>Kleine Tafeln der nächsten drei Themen zur Wahl</translation>
    </message>
    <message>
        <source>drawn without the steps of slices %1 mm apart, at most %2 mm off</source>
        <translation>gezeichnet ohne die Stufen von Schichten im Abstand von %1 mm, höchstens %2 mm daneben</translation>
    </message>
    <message>
        <source>What the scene is about shaded in colour, everything else as quiet context.</source>
        <translation>Worum es in der Szene geht farbig schattiert, alles andere als stiller Kontext.</translation>
    </message>
    <message>
        <source>Even Pen</source>
        <translation>Gleichzug</translation>
    </message>
    <message>
        <source>Outlines and folds in black, all by one pen that never changes its width.</source>
        <translation>Umrisse und Falten in Schwarz, alle mit einer Feder, deren Breite sich nie ändert.</translation>
    </message>
    <message>
        <source>Textbook</source>
        <translation>Lehrbuch</translation>
    </message>
    <message>
        <source>Two colours: black lines, and one colour with a pale tint for what the scene is about.</source>
        <translation>Zwei Farben: schwarze Linien und eine Farbe mit blasser Tönung für das, worum es geht.</translation>
    </message>
    <message>
        <source>Woodcut</source>
        <translation>Holzschnitt</translation>
    </message>
    <message>
        <source>Heavy black lines and dense hatching on white.</source>
        <translation>Kräftige schwarze Linien und dichte Schraffur auf Weiß.</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Bleistift</translation>
    </message>
    <message>
        <source>Fine strokes of graphite on warm paper.</source>
        <translation>Feine Graphitstriche auf warmem Papier.</translation>
    </message>
    <message>
        <source>Operating Note</source>
        <translation>OP-Skizze</translation>
    </message>
    <message>
        <source>A few long lines as a surgeon would sketch them, what matters in one colour.</source>
        <translation>Wenige lange Linien, wie ein Chirurg sie skizzieren würde, das Wichtige in einer Farbe.</translation>
    </message>
    <message>
        <source>Lecture Hall</source>
        <translation>Hörsaal</translation>
    </message>
    <message>
        <source>Bright colours on a dark ground, to be seen from the last row.</source>
        <translation>Leuchtende Farben auf dunklem Grund, bis in die letzte Reihe zu sehen.</translation>
    </message>
    <message>
        <source>What lies inside</source>
        <translation>Was darin liegt</translation>
    </message>
    <message>
        <source>&amp;All Panels</source>
        <translation>&amp;Alle Bedienfelder</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
    <message>
        <source>Hide all panels around the picture, or show them again</source>
        <translation>Alle Bedienfelder um das Bild ausblenden oder wieder zeigen</translation>
    </message>
    <message>
        <source>S&amp;elect</source>
        <translation>Auswä&amp;hlen</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Alle</translation>
    </message>
    <message>
        <source>Select all structures that are shown and not locked</source>
        <translation>Alle Strukturen wählen, die gezeigt werden und nicht gesperrt sind</translation>
    </message>
    <message>
        <source>&amp;Inverse</source>
        <translation>&amp;Umgekehrt</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Select what is shown and not selected, in place of what is</source>
        <translation>Wählen, was gezeigt wird und nicht gewählt ist, statt dessen, was es ist</translation>
    </message>
    <message>
        <source>Same &amp;Kind</source>
        <translation>&amp;Gleiche Art</translation>
    </message>
    <message>
        <source>Shift+G</source>
        <translation>Shift+G</translation>
    </message>
    <message>
        <source>Select what differs from the selected by side or number alone, such as all ribs; again: all of their system</source>
        <translation>Wählen, was sich vom Gewählten nur durch Seite oder Nummer unterscheidet, etwa alle Rippen; noch einmal: alles in ihrem System</translation>
    </message>
    <message>
        <source>&amp;Other Side</source>
        <translation>An&amp;dere Seite</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Select what the selected structures are paired with on the other side of the body</source>
        <translation>Die Gegenstücke der gewählten Strukturen auf der anderen Körperseite wählen</translation>
    </message>
    <message>
        <source>By a &amp;Box</source>
        <translation>Mit einem &amp;Rahmen</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Drag a box in the picture: to the right what lies within, to the left what it touches</source>
        <translation>Einen Rahmen im Bild ziehen: nach rechts, was darin liegt, nach links, was er berührt</translation>
    </message>
    <message>
        <source>Middle click, Page Down, %1</source>
        <translation>Klick mit der Mitteltaste, Bild ab, %1</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Select the next structure before it</source>
        <translation>Die nächste Struktur davor wählen</translation>
    </message>
    <message>
        <source>Select by a box: to the right what lies within, to the left what it touches; with Ctrl in addition</source>
        <translation>Mit einem Rahmen wählen: nach rechts, was darin liegt, nach links, was er berührt; mit Strg zusätzlich</translation>
    </message>
    <message>
        <source>What can be done with the structure there, and all that lies there from front to back</source>
        <translation>Was mit der Struktur dort getan werden kann, und alles, was dort liegt, von vorn nach hinten</translation>
    </message>
    <message>
        <source>Serves %1</source>
        <translation>Versorgt: %1</translation>
    </message>
    <message>
        <source>English / Latin</source>
        <translation>Englisch / Latein</translation>
    </message>
    <message>
        <source>German / Latin</source>
        <translation>Deutsch / Latein</translation>
    </message>
    <message>
        <source>Dutch / Latin</source>
        <translation>Niederländisch / Latein</translation>
    </message>
    <message>
        <source>Norwegian / Latin</source>
        <translation>Norwegisch / Latein</translation>
    </message>
    <message>
        <source>St&amp;yle</source>
        <translation>Stil &amp;mitnehmen</translation>
    </message>
    <message>
        <source>&amp;Copy Style</source>
        <translation>Stil &amp;kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>The whole look of the selected structure, for others</source>
        <translation>Das ganze Aussehen der gewählten Struktur, für andere</translation>
    </message>
    <message>
        <source>&amp;Paste Style</source>
        <translation>Stil &amp;einfügen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied</source>
        <translation>Den gewählten Strukturen das kopierte Aussehen geben</translation>
    </message>
    <message>
        <source>Paste Style, &amp;Keep Colour</source>
        <translation>Stil einfügen, &amp;Farbe behalten</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+V</source>
        <translation>Ctrl+Alt+Shift+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied, but for colour and ink</source>
        <translation>Den gewählten Strukturen das kopierte Aussehen geben, ohne Farbe und Tinte</translation>
    </message>
    <message>
        <source>&amp;Make Like…</source>
        <translation>&amp;Machen wie …</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Click on another structure, in the picture or the list: the selected ones are drawn as it is and keep their colours</source>
        <translation>Auf eine andere Struktur klicken, im Bild oder in der Liste: Die gewählten werden gezeichnet wie sie und behalten ihre Farben</translation>
    </message>
    <message numerus="yes">
        <source>%n labels point with a dashed line to what is hidden in this picture: %1.</source>
        <translation>
            <numerusform>%n Beschriftung zeigt mit gestrichelter Linie auf etwas, das in diesem Bild verdeckt ist: %1.</numerusform>
            <numerusform>%n Beschriftungen zeigen mit gestrichelter Linie auf etwas, das in diesem Bild verdeckt ist: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that shows it, or draw less of what is before it.</source>
        <translation>Wählen Sie eine Ansicht, die es zeigt, oder zeichnen Sie weniger von dem, was davor liegt.</translation>
    </message>
    <message>
        <source>Where a file says nothing of how it looks: a plate draws what it is about in detail and everything else as context, the other styles in their manner</source>
        <translation>Wo eine Datei nicht sagt, wie sie aussieht: Eine Tafel zeichnet, worum es geht, genau und alles andere als Kontext, die anderen Stile auf ihre Weise</translation>
    </message>
    <message>
        <source>Hi&amp;dden Outlines</source>
        <translation>&amp;Verdeckte Umrisse</translation>
    </message>
    <message>
        <source>&amp;Not Drawn</source>
        <translation>&amp;Nicht gezeichnet</translation>
    </message>
    <message>
        <source>Outlines of the selected end where other structures hide them</source>
        <translation>Umrisse des Ausgewählten enden, wo andere Strukturen sie verdecken</translation>
    </message>
    <message>
        <source>&amp;Thin</source>
        <translation>&amp;Dünn</translation>
    </message>
    <message>
        <source>Outlines of the selected go on thinly where other structures hide them</source>
        <translation>Umrisse des Ausgewählten gehen dünn weiter, wo andere Strukturen sie verdecken</translation>
    </message>
    <message>
        <source>&amp;Dashed</source>
        <translation>&amp;Gestrichelt</translation>
    </message>
    <message>
        <source>Outlines of the selected go on dashed where other structures hide them</source>
        <translation>Umrisse des Ausgewählten gehen gestrichelt weiter, wo andere Strukturen sie verdecken</translation>
    </message>
    <message>
        <source>Hidden Outlines</source>
        <translation>Verdeckte Umrisse</translation>
    </message>
    <message>
        <source>Keep unsaved work</source>
        <translation>Nicht gespeicherte Arbeit aufheben</translation>
    </message>
    <message>
        <source>Each change is kept at once, and offered after a crash</source>
        <translation>Jede Änderung wird sofort aufgehoben und nach einem Absturz angeboten</translation>
    </message>
    <message>
        <source>%1 seconds, %2 × %3 pixels, %4 pictures a second.</source>
        <translation>%1 Sekunden, %2 × %3 Pixel, %4 Bilder je Sekunde.</translation>
    </message>
    <message>
        <source>Its size is being measured.</source>
        <translation>Die Größe wird gemessen.</translation>
    </message>
    <message>
        <source>About %1.</source>
        <translation>Etwa %1.</translation>
    </message>
    <message>
        <source>About %1 each.</source>
        <translation>Je etwa %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures found no room in the legend: %1.</source>
        <translation>
            <numerusform>%n Struktur fand keinen Platz in der Legende: %1.</numerusform>
            <numerusform>%n Strukturen fanden keinen Platz in der Legende: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The legend is empty: nothing that is shown has a label, or is in focus.</source>
        <translation>Die Legende ist leer: Nichts Gezeigtes hat eine Beschriftung oder ist im Fokus.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters, or list fewer.</source>
        <translation>Nimm eine größere Seite oder kleinere Buchstaben, oder nenne weniger.</translation>
    </message>
    <message>
        <source>Let it list all structures.</source>
        <translation>Lass sie alle Strukturen nennen.</translation>
    </message>
    <message>
        <source>The sheet labels what is seen.</source>
        <translation>Das Blatt beschriftet, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Nowhere to be seen in this picture: its leader is dashed.</source>
        <translation>Im ganzen Bild nicht zu sehen: Die Linie dorthin ist gestrichelt.</translation>
    </message>
    <message>
        <source>The place set by hand is hidden in this picture: its leader is dashed.</source>
        <translation>Der von Hand gesetzte Ort ist in diesem Bild verdeckt: Die Linie dorthin ist gestrichelt.</translation>
    </message>
    <message>
        <source>Not in this picture: there is no room for it.</source>
        <translation>Nicht in diesem Bild: Dafür ist kein Platz.</translation>
    </message>
    <message>
        <source>Not in this picture: its place is beyond the edge.</source>
        <translation>Nicht in diesem Bild: Der Ort liegt jenseits des Randes.</translation>
    </message>
    <message>
        <source>Not in this picture: nothing is drawn at its place.</source>
        <translation>Nicht in diesem Bild: An diesem Ort ist nichts gezeichnet.</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>ConFIS</source>
        <translation>ConFIS</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Scheinbare Grate</translation>
    </message>
    <message>
        <source>Ridges and valleys</source>
        <translation>Grate und Täler</translation>
    </message>
    <message>
        <source>Photic extremum lines</source>
        <translation>Photische Extremlinien</translation>
    </message>
    <message>
        <source>Laplacian lines</source>
        <translation>Laplace-Linien</translation>
    </message>
    <message>
        <source>Demarcating curves</source>
        <translation>Trennkurven</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanzlinien</translation>
    </message>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ über die Fläche</translation>
    </message>
    <message>
        <source>Thresholds of lines</source>
        <translation>Schwellen der Linien</translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>Glanzlinien</translation>
    </message>
    <message>
        <source>Dκr·F² must be above</source>
        <translation>Dκr·F² muss darüber liegen</translation>
    </message>
    <message>
        <source>acos(nv) must be above, radians</source>
        <translation>acos(nv) muss darüber liegen, Bogenmaß</translation>
    </message>
    <message>
        <source>T/F_c, the thickness of the contour&apos;s margin</source>
        <translation>T/F_c, die Dicke des Saums an der Kontur</translation>
    </message>
    <message>
        <source>|H|·F_c must be above where H has an extremum</source>
        <translation>|H|·F_c muss darüber liegen, wo H ein Extremum hat</translation>
    </message>
    <message>
        <source>the least distance between lines, 1/720 of the picture&apos;s height</source>
        <translation>der kleinste Abstand zwischen Linien, 1/720 der Bildhöhe</translation>
    </message>
    <message>
        <source>q1·F must be above</source>
        <translation>q1·F muss darüber liegen</translation>
    </message>
    <message>
        <source>|κ1|·F must be above</source>
        <translation>|κ1|·F muss darüber liegen</translation>
    </message>
    <message>
        <source>|κ1&apos;&apos;|/|κ1|³ across the line must be above</source>
        <translation>|κ1&apos;&apos;|/|κ1|³ quer zur Linie muss darüber liegen</translation>
    </message>
    <message>
        <source>|∇f|·F must be above</source>
        <translation>|∇f|·F muss darüber liegen</translation>
    </message>
    <message>
        <source>C(g,g,g)·F² must be above</source>
        <translation>C(g,g,g)·F² muss darüber liegen</translation>
    </message>
    <message>
        <source>−Dκr·F² must be above</source>
        <translation>−Dκr·F² muss darüber liegen</translation>
    </message>
    <message>
        <source>κ1²·F² must be above</source>
        <translation>κ1²·F² muss darüber liegen</translation>
    </message>
    <message>
        <source>Compare Tec&amp;hniques…</source>
        <translation>Techniken &amp;vergleichen …</translation>
    </message>
    <message>
        <source>See what is selected, or all, drawn by several line techniques side by side, and save that as a sheet</source>
        <translation>Das Gewählte oder alles in mehreren Linientechniken nebeneinander sehen und als Blatt sichern</translation>
    </message>
    <message numerus="yes">
        <source>%n structures are drawn without noise, which is made of pixels: %1.</source>
        <translation>
            <numerusform>%n Struktur ist ohne Rauschen gezeichnet, das aus Pixeln besteht: %1.</numerusform>
            <numerusform>%n Strukturen sind ohne Rauschen gezeichnet, das aus Pixeln besteht: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export a picture, or take streamline hatching.</source>
        <translation>Exportiere ein Bild oder nimm die Stromlinienschraffur.</translation>
    </message>
    <message>
        <source>What draws the form within contours: suggestive contours and hatching, or short streamlines along contours and where the curvature has an extremum, or lines, streamlines and noise that these are compared with</source>
        <translation>Was die Form innerhalb der Konturen zeichnet: suggestive Konturen und Schraffur, kurze Stromlinien an Konturen und wo die Krümmung ein Extremum hat, oder Linien, Stromlinien und Rauschen, mit denen diese verglichen werden</translation>
    </message>
    <message>
        <source>Streamline hatching</source>
        <translation>Stromlinienschraffur</translation>
    </message>
    <message>
        <source>Noise LIC</source>
        <translation>Rausch-LIC</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Focus by Nearness</source>
        <translation>Fokus nach Nähe</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Das Ausgewählte schattiert, alles andere umso weniger ausgeführt, je weiter weg es ist</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nähe zu einem Ort</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Ein Klick im Bild setzt den Ort, Ziehen bewegt ihn; mit Umschalt in die Tiefe</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Paint on the selected structures where more is to be told than elsewhere</source>
        <translation>Auf die ausgewählten Strukturen malen, wo mehr zu sagen ist als anderswo</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>Paint with a smaller brush</source>
        <translation>Mit einem kleineren Pinsel malen</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>&amp;Größerer Pinsel</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>Paint with a larger brush</source>
        <translation>Mit einem größeren Pinsel malen</translation>
    </message>
    <message>
        <source>&amp;Erase with the Brush</source>
        <translation>Mit dem Pinsel &amp;radieren</translation>
    </message>
    <message>
        <source>Take away what is painted (Ctrl while you paint)</source>
        <translation>Gemaltes wegnehmen (Strg beim Malen)</translation>
    </message>
    <message>
        <source>the distance between lines in full shade, 1/720 of the picture&apos;s height</source>
        <translation>der Abstand der Linien im vollen Schatten, 1/720 der Bildhöhe</translation>
    </message>
    <message>
        <source>the shade must be above, 0 in the light to 1</source>
        <translation>der Schatten muss darüber liegen, 0 im Licht bis 1</translation>
    </message>
    <message numerus="yes">
        <source>%n slides, one for each saved view.</source>
        <translation>
            <numerusform>%n Folie, eine für jede gespeicherte Ansicht.</numerusform>
            <numerusform>%n Folien, eine für jede gespeicherte Ansicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, labels as text and lines.</source>
        <translation>%1, Beschriftungen als Text und Linien.</translation>
    </message>
    <message>
        <source>Names, and the views&apos; texts and notes, are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Namen sowie Texte und Notizen der Ansichten stehen in der Datei, wie die Szene sie hat. Pfade, Benutzernamen, Daten und Patientendaten nicht.</translation>
    </message>
    <message>
        <source>Fi&amp;gure of Several Panels…</source>
        <translation>&amp;Abbildung aus Bildfeldern…</translation>
    </message>
    <message>
        <source>Lay saved views out as panels a, b, c on a page for a journal, with insets, scale bars and one legend</source>
        <translation>Gespeicherte Ansichten als Bildfelder a, b, c auf einer Seite für eine Zeitschrift anordnen, mit Ausschnitten, Maßstäben und einer Legende</translation>
    </message>
    <message numerus="yes">
        <source>%n files, one for each saved view: %1 … %2.</source>
        <translation>
            <numerusform>%n Datei, eine für jede gespeicherte Ansicht: %1 … %2.</numerusform>
            <numerusform>%n Dateien, eine für jede gespeicherte Ansicht: %1 … %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views on about %n pages, with contents, index and bookmarks.</source>
        <translation>
            <numerusform>%1 Ansichten auf etwa %n Seite, mit Inhalt, Verzeichnis und Lesezeichen.</numerusform>
            <numerusform>%1 Ansichten auf etwa %n Seiten, mit Inhalt, Verzeichnis und Lesezeichen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards, in a deck for each view.</source>
        <translation>
            <numerusform>Höchstens %n Karte, in einem Stapel für jede Ansicht.</numerusform>
            <numerusform>Höchstens %n Karten, in einem Stapel für jede Ansicht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards.</source>
        <translation>
            <numerusform>Höchstens %n Karte.</numerusform>
            <numerusform>Höchstens %n Karten.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is seen is also told in words, for who does not see it.</source>
        <translation>Was zu sehen ist, steht auch in Worten darin, für wen es nicht zu sehen ist.</translation>
    </message>
    <message>
        <source>The page has %1 million triangles, too many for telephones.</source>
        <translation>Die Seite hat %1 Millionen Dreiecke, zu viele für Telefone.</translation>
    </message>
    <message>
        <source>Surfaces are simplified and off by %1 mm at most, which the page says.</source>
        <translation>Flächen sind vereinfacht und weichen höchstens %1 mm ab; das sagt die Seite.</translation>
    </message>
    <message>
        <source>The quiz asks nothing, as no label is to be asked for.</source>
        <translation>Das Quiz fragt nichts, denn nach keiner Beschriftung ist zu fragen.</translation>
    </message>
    <message>
        <source>Let surfaces be off by 0.2 mm, or export less.</source>
        <translation>Lass Flächen um 0,2 mm abweichen oder exportiere weniger.</translation>
    </message>
    <message>
        <source>Label structures, or choose no quiz.</source>
        <translation>Beschrifte Strukturen oder wähle kein Quiz.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n questions with pictures.</source>
        <translation>
            <numerusform>Höchstens %n Frage mit Bild.</numerusform>
            <numerusform>Höchstens %n Fragen mit Bildern.</numerusform>
        </translation>
    </message>
    <message>
        <source>No name of a structure can be read in the file; answers are there as checksums. No paths, user names, dates or patient data are.</source>
        <translation>Kein Name einer Struktur ist in der Datei lesbar; Antworten stehen als Prüfsummen darin. Pfade, Benutzernamen, Daten und Patientendaten nicht.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as one does not see there what is named: %1.</source>
        <translation>
            <numerusform>%n Beschriftung wird nicht abgefragt, weil man dort nicht sieht, was sie benennt: %1.</numerusform>
            <numerusform>%n Beschriftungen werden nicht abgefragt, weil man dort nicht sieht, was sie benennen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Vessel, nerve or duct</source>
        <translation>Gefäß, Nerv oder Gang</translation>
    </message>
    <message>
        <source>Vessels, nerves and ducts</source>
        <translation>Gefäße, Nerven und Gänge</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 and %n more</source>
        <translation>
            <numerusform>%1: %2 und %n weitere</numerusform>
            <numerusform>%1: %2 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n patients. Put them into one scene?</source>
        <translation>
            <numerusform>Diese Dateien gehören zu %n Patienten. Sollen sie eine Szene werden?</numerusform>
            <numerusform>Diese Dateien gehören zu %n Patienten. Sollen sie eine Szene werden?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n studies, and nothing says that they are of one patient. Put them into one scene?</source>
        <translation>
            <numerusform>Diese Dateien gehören zu %n Studie, und nichts sagt, dass sie von einem Patienten sind. Sollen sie eine Szene werden?</numerusform>
            <numerusform>Diese Dateien gehören zu %n Studien, und nichts sagt, dass sie von einem Patienten sind. Sollen sie eine Szene werden?</numerusform>
        </translation>
    </message>
    <message>
        <source>Import Together</source>
        <translation>Zusammen importieren</translation>
    </message>
    <message>
        <source>Only the First</source>
        <translation>Nur den ersten</translation>
    </message>
    <message>
        <source>Something in it is at fault and was left out: %1</source>
        <translation>Etwas darin ist fehlerhaft und wurde weggelassen: %1</translation>
    </message>
    <message numerus="yes">
        <source>Something in it is at fault and was left out: %1; and %n more</source>
        <translation>
            <numerusform>Etwas darin ist fehlerhaft und wurde weggelassen: %1; und %n weiteres</numerusform>
            <numerusform>Etwas darin ist fehlerhaft und wurde weggelassen: %1; und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>A newer version of the program has written it; what is unknown here is not shown, and a copy is saved in the form of this version</source>
        <translation>Eine neuere Version des Programms hat sie geschrieben; was hier unbekannt ist, wird nicht gezeigt, und eine Kopie wird in der Form dieser Version gespeichert</translation>
    </message>
    <message>
        <source>It has changed since the program ended with these changes unsaved</source>
        <translation>Sie hat sich geändert, seit das Programm endete und diese Änderungen nicht gespeichert waren</translation>
    </message>
    <message>
        <source>Whether it has changed since the program ended is not known</source>
        <translation>Ob sie sich geändert hat, seit das Programm endete, ist nicht bekannt</translation>
    </message>
    <message>
        <source>Left and Ri&amp;ght</source>
        <translation>&amp;Links und rechts</translation>
    </message>
    <message>
        <source>Sides Are &amp;Right</source>
        <translation>Seiten &amp;stimmen</translation>
    </message>
    <message>
        <source>What was assumed of left and right is so; marks lose their question marks</source>
        <translation>Was über links und rechts angenommen wurde, stimmt; die Zeichen verlieren ihre Fragezeichen</translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation>Links und rechts s&amp;piegeln</translation>
    </message>
    <message>
        <source>Left and right are swapped, front and back are not: the scene becomes its mirror image</source>
        <translation>Links und rechts sind vertauscht, vorn und hinten nicht: Die Szene wird zu ihrem Spiegelbild</translation>
    </message>
    <message>
        <source>&amp;Turn About the Body&apos;s Axis</source>
        <translation>Um die Körperachse &amp;drehen</translation>
    </message>
    <message>
        <source>Left and right are swapped, and front and back, too, as where RAS was taken for LPS: half a turn</source>
        <translation>Links und rechts sind vertauscht, vorn und hinten auch, wie wo RAS für LPS gehalten wurde: eine halbe Drehung</translation>
    </message>
    <message>
        <source>%1, of the smoothed surface</source>
        <translation>%1, der geglätteten Oberfläche</translation>
    </message>
    <message>
        <source>Hide the selected structures</source>
        <translation>Die gewählten Strukturen ausblenden</translation>
    </message>
    <message>
        <source>In &amp;Focus</source>
        <translation>Im &amp;Fokus</translation>
    </message>
    <message>
        <source>Select what is in focus</source>
        <translation>Wählen, was im Fokus ist</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>the view&apos;s text</source>
        <translation>den Text der Ansicht</translation>
    </message>
    <message>
        <source>what Γ follows</source>
        <translation>das, wonach sich Γ richtet</translation>
    </message>
    <message>
        <source>The picture ends %1 mm above its foot, as what is written there has no other room.</source>
        <translation>Das Bild endet %1 mm über seinem Fuß, weil für das, was dort steht, sonst kein Platz ist.</translation>
    </message>
    <message>
        <source>Choose a view that leaves room, or leave words or credits out.</source>
        <translation>Wählen Sie eine Ansicht, die Platz lässt, oder lassen Sie Text oder Quellen weg.</translation>
    </message>
    <message>
        <source>what is open</source>
        <translation>was offen ist</translation>
    </message>
    <message>
        <source>or</source>
        <comment>between two wishes of the filter</comment>
        <translation>oder</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>another than its name says</source>
        <translation>eine andere, als der Name sagt</translation>
    </message>
    <message>
        <source>The file does not say whose work its surfaces are, as their terms ask: %1.</source>
        <translation>Die Datei sagt nicht, von wem ihre Flächen sind, was deren Lizenz verlangt: %1.</translation>
    </message>
    <message>
        <source>The subtitles are empty, as no view says anything.</source>
        <translation>Die Untertitel sind leer, denn keine Ansicht sagt etwas.</translation>
    </message>
    <message>
        <source>Let it say them in a line, or say them where it is published.</source>
        <translation>Lassen Sie es in einer Zeile nennen, oder nennen Sie es dort, wo die Datei erscheint.</translation>
    </message>
    <message>
        <source>Write what views say.</source>
        <translation>Schreiben Sie, was Ansichten sagen.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels stand on anatomy, which leaves no room beside it: %1.</source>
        <translation>
            <numerusform>%n Beschriftung steht auf Anatomie, die neben sich keinen Platz lässt: %1.</numerusform>
            <numerusform>%n Beschriftungen stehen auf Anatomie, die neben sich keinen Platz lässt: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that leaves some, a larger page or smaller letters.</source>
        <translation>Wählen Sie eine Ansicht, die welchen lässt, ein größeres Blatt oder kleinere Schrift.</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 entfernt</translation>
    </message>
    <message>
        <source>%1 (right–left, front–back, foot–head)</source>
        <translation>%1 (rechts–links, vorn–hinten, Fuß–Kopf)</translation>
    </message>
    <message>
        <source>%1 (x, y, z)</source>
        <translation>%1 (x, y, z)</translation>
    </message>
    <message>
        <source>Anatomy leaves no ground for names: the drawing ends at a frame, %1 mm within the page&apos;s left and right edge.</source>
        <translation>Die Anatomie lässt den Namen keinen Grund: Die Zeichnung endet an einem Rahmen, %1 mm innerhalb des linken und rechten Blattrandes.</translation>
    </message>
    <message>
        <source>Choose a view from farther away, or no labels.</source>
        <translation>Wählen Sie eine Ansicht von weiter weg oder keine Beschriftungen.</translation>
    </message>
    <message numerus="yes">
        <source>Names tell that these files are of %n bodies. Put them into one scene?</source>
        <translation>
            <numerusform>Nach den Namen gehören diese Dateien zu %n Körper. Sollen sie eine Szene werden?</numerusform>
            <numerusform>Nach den Namen gehören diese Dateien zu %n Körpern. Sollen sie eine Szene werden?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as what they name may lie on the other side: %1.</source>
        <translation>
            <numerusform>%n Beschriftung wird nicht abgefragt, da das Benannte auf der anderen Seite liegen kann: %1.</numerusform>
            <numerusform>%n Beschriftungen werden nicht abgefragt, da das Benannte auf der anderen Seite liegen kann: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Say that names are right, or give it another name.</source>
        <translation>Sagen Sie, dass Namen stimmen, oder geben Sie einen anderen Namen.</translation>
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
    <name>sline::widgets::AnatomyPalette</name>
    <message>
        <source>Anatomical colours</source>
        <translation>Anatomische Farben</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AnnotationList</name>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>Zeigt auf</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation>Nicht gezeigt</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Beschriftungstext ändern</translation>
    </message>
    <message>
        <source>Show Label</source>
        <translation>Beschriftung zeigen</translation>
    </message>
    <message>
        <source>Hide Label</source>
        <translation>Beschriftung verbergen</translation>
    </message>
    <message>
        <source>Says (%1)</source>
        <translation>Text (%1)</translation>
    </message>
    <message>
        <source>Says (scene’s own)</source>
        <translation>Text (der Szene)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AnnotationsPanel</name>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take this label away</source>
        <translation>Diese Beschriftung wegnehmen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>What the label says</source>
        <translation>Was die Beschriftung sagt</translation>
    </message>
    <message>
        <source>Kind of label</source>
        <translation>Art der Beschriftung</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Of the dot at its place</source>
        <translation>Des Punkts an ihrer Stelle</translation>
    </message>
    <message>
        <source>As the &amp;Ink</source>
        <translation>Wie die &amp;Tinte</translation>
    </message>
    <message>
        <source>Colour of a Label</source>
        <translation>Farbe einer Beschriftung</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Farbe …</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>The mouse does not move it</source>
        <translation>Die Maus bewegt sie nicht</translation>
    </message>
    <message>
        <source>Lock Label</source>
        <translation>Beschriftung sperren</translation>
    </message>
    <message>
        <source>Unlock Label</source>
        <translation>Beschriftung entsperren</translation>
    </message>
    <message>
        <source>Place by Itself</source>
        <translation>Von selbst platzieren</translation>
    </message>
    <message>
        <source>It finds its place again, after it was moved by hand</source>
        <translation>Sie findet ihren Platz wieder selbst, nachdem sie von Hand verschoben wurde</translation>
    </message>
    <message>
        <source>Place Label by Itself</source>
        <translation>Beschriftung von selbst platzieren</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Beschriftung löschen</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Beschriftungstext ändern</translation>
    </message>
    <message>
        <source>Kind of Label</source>
        <translation>Art der Beschriftung</translation>
    </message>
    <message>
        <source>Choose a label</source>
        <translation>Wähle eine Beschriftung</translation>
    </message>
    <message>
        <source>Delete Labels</source>
        <translation>Beschriftungen löschen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushBar</name>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Radius des Pinsels ([ und ])</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>How much weaker the brush is towards its rim</source>
        <translation>Wie viel schwächer der Pinsel zum Rand hin ist</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How much a stroke paints in its middle</source>
        <translation>Wie viel ein Strich in seiner Mitte malt</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Take away instead (Ctrl while you paint)</source>
        <translation>Stattdessen wegnehmen (Strg beim Malen)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Take away all that is painted on the selected</source>
        <translation>Alles wegnehmen, was auf das Ausgewählte gemalt ist</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Put the brush away (Esc)</source>
        <translation>Den Pinsel weglegen (Esc)</translation>
    </message>
    <message>
        <source>Clear Paint</source>
        <translation>Gemaltes leeren</translation>
    </message>
    <message>
        <source>Click on what you want to paint on</source>
        <translation>Klick an, worauf du malen willst</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n Struktur</numerusform>
            <numerusform>%n Strukturen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushTool</name>
    <message>
        <source>Erase on %1</source>
        <translation>Auf %1 radieren</translation>
    </message>
    <message>
        <source>Paint on %1</source>
        <translation>Auf %1 malen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ComparisonDialog</name>
    <message>
        <source>&amp;Save Sheet…</source>
        <translation>&amp;Blatt sichern …</translation>
    </message>
    <message>
        <source>Compare Techniques</source>
        <translation>Techniken vergleichen</translation>
    </message>
    <message>
        <source>Su&amp;rface:</source>
        <translation>&amp;Fläche:</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie sie ist</translation>
    </message>
    <message>
        <source>With staircase</source>
        <translation>Mit Treppenstufen</translation>
    </message>
    <message>
        <source>With jitter</source>
        <translation>Mit Zittern</translation>
    </message>
    <message>
        <source>Roughens the surface, to see which techniques bear what segmentation leaves on it</source>
        <translation>Raut die Fläche auf, um zu sehen, welche Techniken vertragen, was eine Segmentierung auf ihr zurücklässt</translation>
    </message>
    <message>
        <source>Reset &amp;Thresholds</source>
        <translation>&amp;Schwellen zurücksetzen</translation>
    </message>
    <message>
        <source>As PDF, SVG or PNG, with what the pictures take and draw</source>
        <translation>Als PDF, SVG oder PNG, mit dem, was die Bilder brauchen und zeichnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>ms: median time to find and join the lines of a view, contours among them, once the surface is prepared.</source>
        <translation>ms: mittlere Zeit (Median), die Linien einer Ansicht zu finden und zu verbinden, Konturen eingeschlossen, wenn die Fläche vorbereitet ist.</translation>
    </message>
    <message>
        <source>mm⁻¹: length of the technique&apos;s visible lines, without contours, per area that the model covers, as drawn here.</source>
        <translation>mm⁻¹: Länge der sichtbaren Linien der Technik, ohne Konturen, je Fläche, die das Modell bedeckt, wie hier gezeichnet.</translation>
    </message>
    <message>
        <source>F: radius of the model&apos;s bounding sphere; F_c: its median radius of curvature, at most F; H, κ1: mean curvature, the stronger principal curvature; f: light from the eye.</source>
        <translation>F: Radius der Hüllkugel des Modells; F_c: sein mittlerer Krümmungsradius (Median), höchstens F; H, κ1: mittlere Krümmung, die stärkere Hauptkrümmung; f: Licht vom Auge.</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Blatt sichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Drawing the sheet…</source>
        <translation>Das Blatt wird gezeichnet …</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>Ro&amp;w for each</source>
        <translation>&amp;Zeile für jede</translation>
    </message>
    <message>
        <source>Shows what was selected one below the other, else all of it together</source>
        <translation>Zeigt das Gewählte untereinander, sonst alles zusammen</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-Bild (*.tiff)</translation>
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
    <message>
        <source>List of structures</source>
        <translation>Liste der Strukturen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::CubeMark</name>
    <message>
        <source>Orientation cube</source>
        <translation>Orientierungswürfel</translation>
    </message>
    <message>
        <source>The keys A, P, L, R, S and I look from the same sides.</source>
        <translation>Die Tasten A, P, L, R, S und I blicken von denselben Seiten.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::DrawingPanel</name>
    <message>
        <source>Drawing Styles</source>
        <translation>Zeichenstile</translation>
    </message>
    <message>
        <source>Draws the whole scene in one manner</source>
        <translation>Zeichnet die ganze Szene in einer Manier</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Eingeklappt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportActions</name>
    <message>
        <source>The export was stopped</source>
        <translation>Der Export wurde angehalten</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Exportiere %1</translation>
    </message>
    <message numerus="yes">
        <source>Exporting %n files</source>
        <translation>
            <numerusform>Exportiere %n Datei</numerusform>
            <numerusform>Exportiere %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>With the program that this system has for it</source>
        <translation>Mit dem Programm, das dieses System dafür hat</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Ordner zeigen</translation>
    </message>
    <message>
        <source>Where it was written to</source>
        <translation>Wohin geschrieben wurde</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 wurde exportiert</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>%n Datei wurde exportiert</numerusform>
            <numerusform>%n Dateien wurden exportiert</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Das Bild ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>An export is under way. Stop it and close the window?</source>
        <translation>Ein Export ist im Gang. Anhalten und das Fenster schließen?</translation>
    </message>
    <message>
        <source>Stop and Close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Print proof</source>
        <translation>Druckprobe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportDialog</name>
    <message>
        <source>&amp;What the window shows</source>
        <translation>&amp;Was das Fenster zeigt</translation>
    </message>
    <message>
        <source>&amp;Fill the page with what is shown</source>
        <translation>Die Seite mit dem Gezeigten &amp;füllen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Art der Datei</translation>
    </message>
    <message numerus="yes">
        <source>Each sa&amp;ved view, %n files</source>
        <translation>
            <numerusform>&amp;Jede gespeicherte Ansicht, %n Datei</numerusform>
            <numerusform>&amp;Jede gespeicherte Ansicht, %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves the camera to or fro without turning it</source>
        <translation>Bewegt die Kamera vor oder zurück, ohne sie zu drehen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>For this kind</source>
        <translation>Für diese Art</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>At the picture&apos;s edge</source>
        <translation>Am Rand des Bildes</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>What the file will contain</source>
        <translation>Was die Datei enthalten wird</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Du&amp;rchsuchen…</translation>
    </message>
    <message>
        <source>Export To</source>
        <translation>Exportieren nach</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message numerus="yes">
        <source>%n of the files are there already. Replace them?</source>
        <translation>
            <numerusform>%n der Dateien gibt es schon. Ersetzen?</numerusform>
            <numerusform>%n der Dateien gibt es schon. Ersetzen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>In the file&apos;s details</source>
        <translation>In den Angaben der Datei</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
    <message numerus="yes">
        <source>All %n sa&amp;ved views, in one file</source>
        <translation>
            <numerusform>Die %n &amp;gespeicherte Ansicht, in einer Datei</numerusform>
            <numerusform>Alle %n &amp;gespeicherten Ansichten, in einer Datei</numerusform>
        </translation>
    </message>
    <message>
        <source>Each view has a page, a slide or a deck of its own</source>
        <translation>Jede Ansicht hat eine eigene Seite, eine eigene Folie oder einen eigenen Stapel</translation>
    </message>
    <message>
        <source>A file for each view, with its number and name behind the file&apos;s own</source>
        <translation>Eine Datei für jede Ansicht, mit deren Nummer und Namen hinter dem der Datei</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureDialog</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a panel with a view</source>
        <translation>Ein Bildfeld mit einer Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the panel</source>
        <translation>Das Bildfeld entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move the panel up</source>
        <translation>Das Bildfeld nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move the panel down</source>
        <translation>Das Bildfeld nach unten</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Figure of Several Panels</source>
        <translation>Abbildung aus mehreren Bildfeldern</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bildfelder</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Öff&amp;nen…</translation>
    </message>
    <message>
        <source>&amp;Save Figure…</source>
        <translation>Abbildung &amp;sichern…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Another Scene…</source>
        <translation>Andere Szene…</translation>
    </message>
    <message>
        <source>Open Figure</source>
        <translation>Abbildung öffnen</translation>
    </message>
    <message>
        <source>Figures (*.json)</source>
        <translation>Abbildungen (*.json)</translation>
    </message>
    <message>
        <source>Add Views of Another Scene</source>
        <translation>Ansichten einer anderen Szene hinzufügen</translation>
    </message>
    <message>
        <source>Scenes (*.sline)</source>
        <translation>Szenen (*.sline)</translation>
    </message>
    <message>
        <source>Save Figure</source>
        <translation>Abbildung sichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>Export Figure</source>
        <translation>Abbildung exportieren</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>Die Abbildung wird geschrieben …</translation>
    </message>
    <message>
        <source>The figure has changes that are in no file.</source>
        <translation>Die Abbildung hat Änderungen, die in keiner Datei sind.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>As PDF, SVG, PNG or TIFF</source>
        <translation>Als PDF, SVG, PNG oder TIFF</translation>
    </message>
    <message>
        <source>The page as it was; it is being drawn anew…</source>
        <translation>Die Seite, wie sie war; sie wird neu gezeichnet …</translation>
    </message>
    <message>
        <source>The page as it was; %1 has changed</source>
        <translation>Die Seite, wie sie war; %1 hat sich geändert</translation>
    </message>
    <message>
        <source>The page as it was before the last change</source>
        <translation>Die Seite, wie sie vor der letzten Änderung war</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-Bild (*.tiff)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureFields</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>&amp;Width for journals</source>
        <translation>&amp;Breite für Zeitschriften</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>As panels need</source>
        <translation>Wie die Bildfelder sie brauchen</translation>
    </message>
    <message>
        <source>Colum&amp;ns</source>
        <translation>&amp;Spalten</translation>
    </message>
    <message>
        <source>&amp;Letters of panels</source>
        <translation>Buchstaben der Bild&amp;felder</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Their size</source>
        <translation>Ihre Größe</translation>
    </message>
    <message>
        <source>Size of la&amp;bels</source>
        <translation>Größe der Bes&amp;chriftung</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Konturen</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>&amp;Legende</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle Strukturen</translation>
    </message>
    <message>
        <source>What labels point at</source>
        <translation>Worauf Beschriftung zeigt</translation>
    </message>
    <message>
        <source>What is in focus</source>
        <translation>Was im Fokus ist</translation>
    </message>
    <message>
        <source>Per&amp;spective</source>
        <translation>Pers&amp;pektive</translation>
    </message>
    <message>
        <source>As views were saved</source>
        <translation>Wie die Ansichten gesichert sind</translation>
    </message>
    <message>
        <source>T&amp;hin lines</source>
        <translation>&amp;Dünne Linien</translation>
    </message>
    <message>
        <source>Drawn wide enough to print</source>
        <translation>So breit, dass sie drucken</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Labels in all panels</source>
        <translation>Beschriftung in allen Bildfeldern</translation>
    </message>
    <message>
        <source>Scale bars in all panels</source>
        <translation>Maßstab in allen Bildfeldern</translation>
    </message>
    <message>
        <source>R and L in all panels</source>
        <translation>R und L in allen Bildfeldern</translation>
    </message>
    <message>
        <source>Black and white</source>
        <translation>Schwarz-Weiß</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>Part of %1</source>
        <translation>Ausschnitt von %1</translation>
    </message>
    <message>
        <source>On its panel</source>
        <translation>Auf seinem Bildfeld</translation>
    </message>
    <message>
        <source>Lines from its frame</source>
        <translation>Linien von seinem Rahmen</translation>
    </message>
    <message>
        <source>As its view has it</source>
        <translation>Wie seine Ansicht</translation>
    </message>
    <message>
        <source>Fitted to the panel</source>
        <translation>Ins Bildfeld eingepasst</translation>
    </message>
    <message>
        <source>Like %1</source>
        <translation>Wie %1</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>K&amp;amera</translation>
    </message>
    <message>
        <source>As its panel</source>
        <translation>Wie sein Bildfeld</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Spans columns</source>
        <translation>Über Spalten</translation>
    </message>
    <message>
        <source>Spans rows</source>
        <translation>Über Zeilen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>A panel may have a choice of its own</source>
        <translation>Ein Bildfeld kann es anders haben</translation>
    </message>
    <message>
        <source>If not as in the other panels</source>
        <translation>Wenn nicht wie in den anderen Bildfeldern</translation>
    </message>
    <message>
        <source>One column of a journal, one and a half, or two</source>
        <translation>Eine Spalte einer Zeitschrift, anderthalb oder zwei</translation>
    </message>
    <message>
        <source>For pages that no journal prescribes</source>
        <translation>Für Seiten, die keine Zeitschrift vorschreibt</translation>
    </message>
    <message>
        <source>Without it panels are 4 by 3 and the legend has its room</source>
        <translation>Ohne sie sind Bildfelder 4 zu 3, und die Legende hat ihren Platz</translation>
    </message>
    <message>
        <source>Into how many columns the page is divided; panels fill it by rows</source>
        <translation>In wie viele Spalten die Seite geteilt ist; Bildfelder füllen sie Zeile für Zeile</translation>
    </message>
    <message>
        <source>Bold, at the upper left of each panel</source>
        <translation>Fett, oben links in jedem Bildfeld</translation>
    </message>
    <message>
        <source>How large the letters of panels are</source>
        <translation>Wie groß die Buchstaben der Bildfelder sind</translation>
    </message>
    <message>
        <source>How wide contours are, the same in all panels</source>
        <translation>Wie breit Konturen sind, in allen Bildfeldern gleich</translation>
    </message>
    <message>
        <source>One legend for all panels, at the foot of the page</source>
        <translation>Eine Legende für alle Bildfelder, am Fuß der Seite</translation>
    </message>
    <message>
        <source>Without perspective a scale bar is true everywhere</source>
        <translation>Ohne Perspektive stimmt ein Maßstab überall</translation>
    </message>
    <message>
        <source>And the other sides of the body</source>
        <translation>Und die anderen Seiten des Körpers</translation>
    </message>
    <message>
        <source>Ink alone, without tones and colours</source>
        <translation>Nur Tinte, ohne Töne und Farben</translation>
    </message>
    <message>
        <source>A saved view of the scene, or a side of the body</source>
        <translation>Eine gespeicherte Ansicht der Szene oder eine Seite des Körpers</translation>
    </message>
    <message>
        <source>Like another panel: of the same direction and scale, to be compared</source>
        <translation>Wie ein anderes Bildfeld: mit gleicher Richtung und gleichem Maßstab, zum Vergleichen</translation>
    </message>
    <message>
        <source>The enlarged part lies on the panel of which it is a part</source>
        <translation>Der vergrößerte Teil liegt auf dem Bildfeld, von dem er ein Teil ist</translation>
    </message>
    <message>
        <source>From the corners of the frame to those of the enlarged part</source>
        <translation>Von den Ecken des Rahmens zu denen des vergrößerten Teils</translation>
    </message>
    <message>
        <source>How many columns of the page the panel is wide</source>
        <translation>Über wie viele Spalten der Seite das Bildfeld reicht</translation>
    </message>
    <message>
        <source>How many rows of the page the panel is high</source>
        <translation>Über wie viele Zeilen der Seite das Bildfeld reicht</translation>
    </message>
    <message>
        <source>How far panels are apart</source>
        <translation>Wie weit Bildfelder voneinander entfernt sind</translation>
    </message>
    <message>
        <source>So that sizes compare: one scale bar is true for all panels; enlarged parts stay enlarged</source>
        <translation>Damit sich Größen vergleichen lassen: Ein Maßstab gilt für alle Bildfelder; vergrößerte Ausschnitte bleiben vergrößert</translation>
    </message>
    <message>
        <source>Of labels, scale bars and the legend, as in de, la or de+la; empty: the scene&apos;s own</source>
        <translation>Von Beschriftungen, Maßstäben und Legende, wie de, la oder de+la; leer: die der Szene</translation>
    </message>
    <message>
        <source>A figure with smaller ones is refused</source>
        <translation>Eine Abbildung mit kleineren wird abgelehnt</translation>
    </message>
    <message>
        <source>What thin lines are measured by</source>
        <translation>Woran dünne Linien gemessen werden</translation>
    </message>
    <message>
        <source>Scale bars and the legend are a fifth smaller</source>
        <translation>Maßstäbe und Legende sind ein Fünftel kleiner</translation>
    </message>
    <message>
        <source>What becomes of lines that are too thin to print; hatching stays</source>
        <translation>Was aus Linien wird, die zum Drucken zu dünn sind; Schraffuren bleiben</translation>
    </message>
    <message>
        <source>Moved aside to the middle of what this panel shows</source>
        <translation>Zur Seite verschoben auf die Mitte dessen, was dieses Bildfeld zeigt</translation>
    </message>
    <message>
        <source>In place of the next one; a blank for none</source>
        <translation>Anstelle des nächsten; ein Leerzeichen für keinen</translation>
    </message>
    <message>
        <source>Between panels</source>
        <translation>Zwischen Bildfeldern</translation>
    </message>
    <message>
        <source>Smallest letters</source>
        <translation>Kleinste Schrift</translation>
    </message>
    <message>
        <source>Thinnest lines</source>
        <translation>Dünnste Linien</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Same scale in all panels</source>
        <translation>Gleicher Maßstab in allen Bildfeldern</translation>
    </message>
    <message>
        <source>On its own middle</source>
        <translation>Auf die eigene Mitte</translation>
    </message>
    <message>
        <source>R and L</source>
        <translation>R und L</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Buchstabe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigurePreview</name>
    <message>
        <source>The figure</source>
        <translation>Die Abbildung</translation>
    </message>
    <message>
        <source>Drag a rectangle in a panel to show that part enlarged</source>
        <translation>Zieh ein Rechteck in einem Bildfeld auf, um diesen Teil vergrößert zu zeigen</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureWriting</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>Die Abbildung wird geschrieben …</translation>
    </message>
    <message>
        <source>Stop writing; a file that was there before stays as it is</source>
        <translation>Nicht weiter schreiben; eine Datei, die schon da war, bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Abgebrochen; es wurde nichts geschrieben</translation>
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
    <name>sline::widgets::FilePager</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
    <message>
        <source>Preview of what comes before</source>
        <translation>Vorschau auf das Vorige</translation>
    </message>
    <message>
        <source>Preview of what comes next</source>
        <translation>Vorschau auf das Nächste</translation>
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
    <message>
        <source>Opening look</source>
        <translation>Aussehen beim Öffnen</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>set by hand since</source>
        <translation>seither von Hand eingestellt</translation>
    </message>
    <message>
        <source>Back to the focus</source>
        <translation>Zurück zum Fokus</translation>
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
    <message>
        <source>Set by hand since; the focus leaves it so</source>
        <translation>Seither von Hand eingestellt; der Fokus lässt es so</translation>
    </message>
    <message>
        <source>%1 – by hand</source>
        <translation>%1 – von Hand</translation>
    </message>
    <message>
        <source>Draws them as the focus would; only those chosen in the list, if any</source>
        <translation>Zeichnet sie, wie der Fokus es täte; nur die in der Liste gewählten, falls es welche gibt</translation>
    </message>
    <message numerus="yes">
        <source>%n by Hand: Back to the Focus</source>
        <translation>
            <numerusform>%n von Hand: zurück zum Fokus</numerusform>
            <numerusform>%n von Hand: zurück zum Fokus</numerusform>
        </translation>
    </message>
    <message>
        <source>Nearness to a place</source>
        <translation>Nähe zu einem Ort</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaCurve</name>
    <message>
        <source>Curve of Γ</source>
        <translation>Kurve von Γ</translation>
    </message>
    <message>
        <source>What is added to Γ, from left to right along the value. Drag a point; a double click or Insert adds one, Delete takes one away. Arrow keys move the chosen point, Space chooses the next</source>
        <translation>Was zu Γ hinzukommt, von links nach rechts entlang des Werts. Punkte lassen sich ziehen; ein Doppelklick oder Einfg fügt einen hinzu, Entf nimmt einen weg. Pfeiltasten bewegen den gewählten Punkt, die Leertaste wählt den nächsten</translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 at %4</source>
        <translation>Punkt %1 von %2: %3 bei %4</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaMapEditor</name>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ über die Fläche</translation>
    </message>
    <message>
        <source>Lets Γ vary from place to place on a structure</source>
        <translation>Lässt Γ von Ort zu Ort auf einer Struktur verschieden sein</translation>
    </message>
    <message>
        <source>The same everywhere</source>
        <translation>Überall gleich</translation>
    </message>
    <message>
        <source>By cavities</source>
        <translation>Nach Höhlungen</translation>
    </message>
    <message>
        <source>By curvature</source>
        <translation>Nach Krümmung</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Nach Abstand</translation>
    </message>
    <message>
        <source>Several</source>
        <translation>Mehrere</translation>
    </message>
    <message>
        <source>Distance from</source>
        <translation>Abstand von</translation>
    </message>
    <message>
        <source>The structure or group from which distances are measured</source>
        <translation>Die Struktur oder Gruppe, von der aus Abstände gemessen werden</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n Element</numerusform>
            <numerusform>%n Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Malen …</translation>
    </message>
    <message>
        <source>By painting</source>
        <translation>Nach Gemaltem</translation>
    </message>
    <message>
        <source>Cavities: how much of its own sky the surface hides, 0 to 1. Curvature: 1 on a ball, negative in hollows. Distance: millimetres from another structure. Painting: what you paint in the picture, 0 to 1</source>
        <translation>Höhlungen: wie viel von ihrem eigenen Himmel die Fläche verdeckt, 0 bis 1. Krümmung: 1 auf einer Kugel, negativ in Mulden. Abstand: Millimeter von einer anderen Struktur. Gemaltes: was du im Bild malst, 0 bis 1</translation>
    </message>
    <message>
        <source>Paint in the picture with a brush</source>
        <translation>Mit einem Pinsel im Bild malen</translation>
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
        <source>Inherit Γ</source>
        <translation>Γ erben</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>A number that is typed is for all that is selected</source>
        <translation>Eine eingegebene Zahl gilt für alles, was gewählt ist</translation>
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
    <name>sline::widgets::ImportActions</name>
    <message>
        <source>The Size Is Right</source>
        <translation>Die Größe stimmt</translation>
    </message>
    <message>
        <source>The size is right</source>
        <translation>Die Größe stimmt</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>%1 als Einheit nehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read as %1, unlike alone: so they go with the open scene</source>
        <translation>
            <numerusform>%n Struktur wurde als %1 gelesen, anders als allein: So passt sie zur offenen Szene</numerusform>
            <numerusform>%n Strukturen wurden als %1 gelesen, anders als allein: So passen sie zur offenen Szene</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>Filter by name or file</source>
        <translation>Nach Name oder Datei filtern</translation>
    </message>
    <message>
        <source>What is left out or mended</source>
        <translation>Was weggelassen oder ausgebessert wird</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>What happened, and what to do</source>
        <translation>Was geschehen ist und was zu tun ist</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Opens what is listed as a scene of its own</source>
        <translation>Öffnet das Aufgeführte als eigene Szene</translation>
    </message>
    <message>
        <source>Add to Scene</source>
        <translation>Zur Szene hinzufügen</translation>
    </message>
    <message>
        <source>Puts what is listed below the structures of the open scene</source>
        <translation>Fügt das Aufgeführte unter den Strukturen der offenen Szene ein</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>Left out or mended</source>
        <translation>Weggelassen oder ausgebessert</translation>
    </message>
    <message>
        <source>Left out or mended (%1)</source>
        <translation>Weggelassen oder ausgebessert (%1)</translation>
    </message>
    <message>
        <source>Nothing can be imported</source>
        <translation>Es gibt nichts zu importieren</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>The Size Is Right</source>
        <translation>Die Größe stimmt</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>%1 als Einheit nehmen</translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either</source>
        <translation>Wörter in beliebiger Reihenfolge; „%1“ oder ein Komma dazwischen findet jedes von beiden</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDraft</name>
    <message>
        <source>LPS – left, posterior, superior</source>
        <translation>LPS – links, hinten, oben</translation>
    </message>
    <message>
        <source>RAS – right, anterior, superior</source>
        <translation>RAS – rechts, vorn, oben</translation>
    </message>
    <message>
        <source>As in the file, unturned</source>
        <translation>Wie in der Datei, ungedreht</translation>
    </message>
    <message>
        <source>mm – millimetres</source>
        <translation>mm – Millimeter</translation>
    </message>
    <message>
        <source>cm – centimetres</source>
        <translation>cm – Zentimeter</translation>
    </message>
    <message>
        <source>m – metres</source>
        <translation>m – Meter</translation>
    </message>
    <message>
        <source>in – inches</source>
        <translation>in – Zoll</translation>
    </message>
    <message>
        <source>µm – micrometres</source>
        <translation>µm – Mikrometer</translation>
    </message>
    <message>
        <source>Å – ångström</source>
        <translation>Å – Ångström</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Alle behalten</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>within %1 mm</source>
        <translation>innerhalb %1 mm</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>as the scene file has it</source>
        <translation>wie die Szenendatei es hat</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>; und %n weitere</numerusform>
            <numerusform>; und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n Struktur</numerusform>
            <numerusform>%n Strukturen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n groups</source>
        <translation>
            <numerusform>%n Gruppe</numerusform>
            <numerusform>%n Gruppen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n übersprungen</numerusform>
            <numerusform>%n übersprungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Everything together is %1 mm large</source>
        <translation>Alles zusammen ist %1 mm groß</translation>
    </message>
    <message>
        <source>%1. If the files are in %2, it is %3 mm.</source>
        <translation>%1. Wenn die Dateien in %2 sind, sind es %3 mm.</translation>
    </message>
    <message>
        <source>%1, which is small for anatomy.</source>
        <translation>%1, das ist klein für Anatomie.</translation>
    </message>
    <message>
        <source>%1, which is large for anatomy.</source>
        <translation>%1, das ist groß für Anatomie.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures lie on the other side than their names say: %1.</source>
        <translation>
            <numerusform>%n Struktur liegt auf der anderen Seite, als ihr Name sagt: %1.</numerusform>
            <numerusform>%n Strukturen liegen auf der anderen Seite, als ihre Namen sagen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles, %4</source>
        <translation>%1: %2, %3 Dreiecke, %4</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, aus %2</translation>
    </message>
    <message>
        <source>From a scene file: it keeps its place, size and triangles.</source>
        <translation>Aus einer Szenendatei: sie behält Lage, Größe und Dreiecke.</translation>
    </message>
    <message>
        <source>Frame: %1</source>
        <translation>Koordinatensystem: %1</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>Einheit: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n faces mended</source>
        <translation>
            <numerusform>%n Fläche ausgebessert</numerusform>
            <numerusform>%n Flächen ausgebessert</numerusform>
        </translation>
    </message>
    <message>
        <source>Its name says the other side than it lies on.</source>
        <translation>Ihr Name sagt die andere Seite als die, auf der sie liegt.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>LAS – left, anterior, superior (mirrors)</source>
        <translation>LAS – links, anterior, superior (spiegelt)</translation>
    </message>
    <message>
        <source>RPS – right, posterior, superior (mirrors)</source>
        <translation>RPS – rechts, posterior, superior (spiegelt)</translation>
    </message>
    <message numerus="yes">
        <source>Left and right look swapped: all %n structures with a side in their names lie on the other side (%1).</source>
        <translation>
            <numerusform>Links und rechts scheinen vertauscht: %n Struktur mit einer Seite im Namen liegt auf der anderen Seite (%1).</numerusform>
            <numerusform>Links und rechts scheinen vertauscht: alle %n Strukturen mit einer Seite im Namen liegen auf der anderen Seite (%1).</numerusform>
        </translation>
    </message>
    <message>
        <source>Front and back are right: if the files are mirrored, choose %1.</source>
        <translation>Vorn und hinten stimmen: Sind die Dateien gespiegelt, wähle %1.</translation>
    </message>
    <message>
        <source>Choose %1.</source>
        <translation>Wähle %1.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::IntensityRange</name>
    <message>
        <source>Intensities</source>
        <translation>Intensitäten</translation>
    </message>
    <message>
        <source>How often each intensity occurs. Drag the bounds; on the keyboard the arrows move the lower one, with Shift the upper one</source>
        <translation>Wie oft jede Intensität vorkommt. Ziehe die Grenzen; auf der Tastatur bewegen die Pfeile die untere, mit der Umschalttaste die obere</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelActions</name>
    <message>
        <source>Click on two places to measure between them; Esc ends this</source>
        <translation>Auf zwei Stellen klicken, um dazwischen zu messen; Esc beendet das</translation>
    </message>
    <message>
        <source>Click on a place to mark it; Esc ends this</source>
        <translation>Auf eine Stelle klicken, um sie zu markieren; Esc beendet das</translation>
    </message>
    <message>
        <source>Click on a structure and type; Shift+Return begins a line, Esc ends this</source>
        <translation>Auf eine Struktur klicken und schreiben; Umschalt+Enter beginnt eine Zeile, Esc beendet das</translation>
    </message>
    <message>
        <source>Click on a structure and type; Esc ends this</source>
        <translation>Auf eine Struktur klicken und schreiben; Esc beendet das</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n labels</source>
        <translation>
            <numerusform>%n Beschriftung hinzufügen</numerusform>
            <numerusform>%n Beschriftungen hinzufügen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels added</source>
        <translation>
            <numerusform>%n Beschriftung hinzugefügt</numerusform>
            <numerusform>%n Beschriftungen hinzugefügt</numerusform>
        </translation>
    </message>
    <message>
        <source>What is selected has labels already, or is not in the picture</source>
        <translation>Das Ausgewählte ist schon beschriftet oder nicht im Bild</translation>
    </message>
    <message>
        <source>Nothing is there: click on a structure</source>
        <translation>Dort ist nichts: auf eine Struktur klicken</translation>
    </message>
    <message>
        <source>Label added; %1</source>
        <translation>Beschriftung hinzugefügt; %1</translation>
    </message>
    <message>
        <source>shown in %1 of %2 saved views: the panel Labels says in which</source>
        <translation>gezeigt in %1 von %2 gespeicherten Ansichten: Das Feld „Beschriftungen“ sagt, in welchen</translation>
    </message>
    <message numerus="yes">
        <source>%n have no room in this picture: the panel Labels says which</source>
        <translation>
            <numerusform>%n hat in diesem Bild keinen Platz: Das Feld „Beschriftungen“ sagt, welche</numerusform>
            <numerusform>%n haben in diesem Bild keinen Platz: Das Feld „Beschriftungen“ sagt, welche</numerusform>
        </translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Abstand hinzufügen</translation>
    </message>
    <message>
        <source>The shortest distance between the two selected structures was added; with another selection you choose two places</source>
        <translation>Der kürzeste Abstand zwischen den zwei gewählten Strukturen wurde hinzugefügt; bei anderer Auswahl wählst du zwei Orte</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelEditor</name>
    <message>
        <source>What the label says</source>
        <translation>Was die Beschriftung sagt</translation>
    </message>
    <message>
        <source>Return takes it over, Shift+Return begins a line, Esc forgets it</source>
        <translation>Enter übernimmt es, Umschalt+Enter beginnt eine Zeile, Esc verwirft es</translation>
    </message>
    <message>
        <source>Return takes it over, Esc forgets it</source>
        <translation>Enter übernimmt es, Esc verwirft es</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelField</name>
    <message>
        <source>**bold** (%1), *italic* (%2); lines that begin with “- ” are a list</source>
        <translation>**fett** (%1), *kursiv* (%2); Zeilen, die mit „- “ beginnen, werden eine Liste</translation>
    </message>
    <message>
        <source>In presentations and on students&apos; pages [ureter](#structure=left ureter) lights that structure up, and [from behind](#view=2) goes to a view</source>
        <translation>Beim Vorführen und auf Seiten für Studierende hebt [Harnleiter](#structure=linker Harnleiter) diese Struktur hervor, und [von hinten](#view=2) geht zu einer Ansicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelTool</name>
    <message>
        <source>Move Label</source>
        <translation>Beschriftung verschieben</translation>
    </message>
    <message>
        <source>Move What a Label Points At</source>
        <translation>Verschieben, worauf eine Beschriftung zeigt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelViews</name>
    <message>
        <source>Views that show it</source>
        <translation>Ansichten, die sie zeigen</translation>
    </message>
    <message>
        <source>Which of the saved views show it</source>
        <translation>Welche der gespeicherten Ansichten sie zeigen</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>A tick for each saved view that shows what is chosen in the list</source>
        <translation>Ein Haken für jede gespeicherte Ansicht, die zeigt, was in der Liste ausgewählt ist</translation>
    </message>
    <message>
        <source>In all views</source>
        <translation>In allen Ansichten</translation>
    </message>
    <message>
        <source>Only in %1</source>
        <translation>Nur in %1</translation>
    </message>
    <message>
        <source>In different views</source>
        <translation>In verschiedenen Ansichten</translation>
    </message>
    <message>
        <source>In no view</source>
        <translation>In keiner Ansicht</translation>
    </message>
    <message numerus="yes">
        <source>In %n views</source>
        <translation>
            <numerusform>In %n Ansicht</numerusform>
            <numerusform>In %n Ansichten</numerusform>
        </translation>
    </message>
    <message>
        <source>Views of a Label</source>
        <translation>Ansichten einer Beschriftung</translation>
    </message>
    <message>
        <source>%1 (some of them)</source>
        <comment>a saved view that shows some of the labels</comment>
        <translation>%1 (einige davon)</translation>
    </message>
    <message>
        <source>In All Views</source>
        <translation>In allen Ansichten</translation>
    </message>
    <message>
        <source>In No View</source>
        <translation>In keiner Ansicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LongestText</name>
    <message numerus="yes">
        <source>At most %n characters have room here</source>
        <translation>
            <numerusform>Hier ist Platz für höchstens %n Zeichen</numerusform>
            <numerusform>Hier ist Platz für höchstens %n Zeichen</numerusform>
        </translation>
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
        <source>Turning around this place on %1</source>
        <translation>Dreht um diese Stelle an %1</translation>
    </message>
    <message>
        <source>Focus and Context</source>
        <translation>Fokus und Kontext</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Structures: %1   Triangles: %2 (refined)</source>
        <translation>Strukturen: %1   Dreiecke: %2 (verfeinert)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ManagePresetsDialog</name>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
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
    <name>sline::widgets::MorePanel</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Eingeklappt</translation>
    </message>
    <message>
        <source>Lines, hatching, opacity and colours</source>
        <translation>Linien, Schraffur, Deckkraft und Farben</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearRow</name>
    <message>
        <source>By Nearness</source>
        <translation>Nach Nähe</translation>
    </message>
    <message>
        <source>Near a Place</source>
        <translation>Nahe einem Ort</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Das Ausgewählte schattiert, alles andere umso weniger ausgeführt, je weiter weg es ist</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Ein Klick im Bild setzt den Ort, Ziehen bewegt ihn; mit Umschalt in die Tiefe</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>From what distance on there are only silhouettes</source>
        <translation>Ab welchem Abstand es nur Silhouetten gibt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearTool</name>
    <message>
        <source>Focus by Nearness</source>
        <translation>Fokus nach Nähe</translation>
    </message>
    <message>
        <source>Reach of Nearness</source>
        <translation>Reichweite der Nähe</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nähe zu einem Ort</translation>
    </message>
    <message>
        <source>Move the Place</source>
        <translation>Ort verschieben</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NumberLimits</name>
    <message>
        <source>Numbers from %1 to %2 can be set here</source>
        <translation>Hier lassen sich Zahlen von %1 bis %2 einstellen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::OptionsPanel</name>
    <message>
        <source>&amp;Mend faces</source>
        <translation>Flächen aus&amp;bessern</translation>
    </message>
    <message>
        <source>Lay molecules &amp;over each other</source>
        <translation>Moleküle über&amp;einanderlegen</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Wie gefunden</translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Alle behalten</translation>
    </message>
    <message>
        <source>As few triangles as can be with no part of a surface moved by more than this</source>
        <translation>So wenige Dreiecke wie möglich, ohne dass sich ein Teil einer Oberfläche um mehr als dies verschiebt</translation>
    </message>
    <message>
        <source>Leaves out faces without area or given twice, and turns those that look inwards</source>
        <translation>Lässt Flächen ohne Inhalt und doppelte weg und dreht die um, die nach innen blicken</translation>
    </message>
    <message>
        <source>Coor&amp;dinates</source>
        <translation>Koor&amp;dinaten</translation>
    </message>
    <message>
        <source>&amp;Length of a unit</source>
        <translation>&amp;Länge einer Einheit</translation>
    </message>
    <message>
        <source>Fewer t&amp;riangles, within</source>
        <translation>Weniger D&amp;reiecke, innerhalb</translation>
    </message>
    <message>
        <source>S&amp;moothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>Automatic: takes away the steps of label maps, and refines what is too coarse to draw; steps: so much everywhere</source>
        <translation>Automatisch: nimmt Labelkarten die Stufen und verfeinert, was zum Zeichnen zu grob ist; Schritte: überall so viel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Kee&amp;p names</source>
        <translation>Namen be&amp;halten</translation>
    </message>
    <message>
        <source>Names of files, folders and what is in them stay whole; else words that are no anatomy are left out, as they may be a person&apos;s name</source>
        <translation>Namen von Dateien, Ordnern und dem, was in ihnen ist, bleiben ganz; sonst entfallen Wörter, die nicht zur Anatomie gehören, denn sie können der Name einer Person sein</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PagePanel</name>
    <message>
        <source>T&amp;urn</source>
        <translation>Dre&amp;hen</translation>
    </message>
    <message>
        <source>Reso&amp;lution</source>
        <translation>Auf&amp;lösung</translation>
    </message>
    <message>
        <source>Custom size</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>Upright or lying: width and height change places</source>
        <translation>Hoch- oder Querformat: Breite und Höhe tauschen die Plätze</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Unit of width and height</source>
        <translation>Einheit von Breite und Höhe</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureLabels</name>
    <message>
        <source>Add Callout</source>
        <translation>Textfeld hinzufügen</translation>
    </message>
    <message>
        <source>Add Pin</source>
        <translation>Nadel hinzufügen</translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Maß hinzufügen</translation>
    </message>
    <message>
        <source>Add Label</source>
        <translation>Beschriftung hinzufügen</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Beschriftungstext ändern</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Beschriftung löschen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureMarks</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 at %2 % size</source>
        <translation>%1 bei %2 % Größe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureMenu</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Section &amp;Here</source>
        <translation>Schnitt &amp;hier</translation>
    </message>
    <message>
        <source>Section Here, of &amp;This Alone</source>
        <translation>Schnitt hier, nur von &amp;diesem</translation>
    </message>
    <message>
        <source>Turn &amp;Around This Place</source>
        <translation>&amp;Um diese Stelle drehen</translation>
    </message>
    <message>
        <source>Select Here</source>
        <translation>Hier auswählen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureScreen</name>
    <message>
        <source>none, as the processor draws</source>
        <translation>keines, da der Prozessor zeichnet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PlanTree</name>
    <message>
        <source>What would be imported</source>
        <translation>Was importiert würde</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PlanTreeModel</name>
    <message>
        <source>Å</source>
        <translation>Å</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Fewer triangles</source>
        <translation>Weniger Dreiecke</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PocketsPanel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n residues at its wall: %1</source>
        <translation>
            <numerusform>%n Rest an ihrer Wand: %1</numerusform>
            <numerusform>%n Reste an ihrer Wand: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>Volume Å³</source>
        <translation>Volumen Å³</translation>
    </message>
    <message>
        <source>Mouth Å²</source>
        <translation>Mündung Å²</translation>
    </message>
    <message>
        <source>Burial</source>
        <translation>Tiefe Lage</translation>
    </message>
    <message>
        <source>The room that the small probe can fill</source>
        <translation>Der Raum, den die kleine Kugel füllen kann</translation>
    </message>
    <message>
        <source>The surface across which the pocket is open; 0: it is closed</source>
        <translation>Die Fläche, über die die Tasche offen ist; 0: sie ist geschlossen</translation>
    </message>
    <message>
        <source>The share of directions in which atoms lie within 10 Å</source>
        <translation>Der Anteil der Richtungen, in denen Atome innerhalb von 10 Å liegen</translation>
    </message>
    <message>
        <source>Its number, and what lies in it</source>
        <translation>Ihre Nummer und was in ihr liegt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Pockets</source>
        <translation>Taschen</translation>
    </message>
    <message>
        <source>Click a pocket to put it in focus, with what lies in it</source>
        <translation>Klicke auf eine Tasche, um sie mit dem, was in ihr liegt, in den Fokus zu stellen</translation>
    </message>
    <message>
        <source>Radius of the ball that goes into pockets; water has 1.4 Å</source>
        <translation>Radius der Kugel, die in Taschen hineingeht; Wasser hat 1,4 Å</translation>
    </message>
    <message>
        <source>Radius of the ball that stays out: with a larger one, shallower and wider pockets count</source>
        <translation>Radius der Kugel, die draußen bleibt: mit einer größeren zählen auch flachere und weitere Taschen</translation>
    </message>
    <message>
        <source> Å³</source>
        <translation> Å³</translation>
    </message>
    <message>
        <source>Smaller pockets are left out</source>
        <translation>Kleinere Taschen entfallen</translation>
    </message>
    <message>
        <source>&amp;Probe radius</source>
        <translation>&amp;Kugelradius</translation>
    </message>
    <message>
        <source>&amp;Large probe</source>
        <translation>&amp;Große Kugel</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>K&amp;leinste</translation>
    </message>
    <message>
        <source> Å</source>
        <translation> Å</translation>
    </message>
    <message>
        <source>Looking for pockets …</source>
        <translation>Taschen werden gesucht …</translation>
    </message>
    <message>
        <source>Open a protein from a PDB or mmCIF file to see its pockets here.</source>
        <translation>Öffne ein Protein aus einer PDB- oder mmCIF-Datei, um hier seine Taschen zu sehen.</translation>
    </message>
    <message>
        <source>Nothing was looked for. Change a radius to start.</source>
        <translation>Es wurde nichts gesucht. Ändere einen Radius, um zu beginnen.</translation>
    </message>
    <message numerus="yes">
        <source>%n pockets</source>
        <translation>
            <numerusform>%n Tasche</numerusform>
            <numerusform>%n Taschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket %1 in Focus</source>
        <translation>Tasche %1 im Fokus</translation>
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
    <name>sline::widgets::Presentation</name>
    <message>
        <source>%1 / %2   %3</source>
        <comment>number of the view, of so many, its name</comment>
        <translation>%1 / %2   %3</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>number of the view, of so many</comment>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PresentedQuiz</name>
    <message>
        <source>No label here names anything to ask for</source>
        <translation>Keine Beschriftung hier benennt etwas, wonach sich fragen ließe</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <comment>answers of a quiz</comment>
        <translation>%1 von %2 richtig</translation>
    </message>
    <message>
        <source>%1 / %2   Point at: %3</source>
        <comment>number of the question, of so many, what to point at</comment>
        <translation>%1 / %2   Zeige auf: %3</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <comment>answer of a quiz</comment>
        <translation>Richtig: %1</translation>
    </message>
    <message>
        <source>No, that is: %1. Outlined is: %2</source>
        <comment>answer of a quiz</comment>
        <translation>Nein, das ist: %1. Umrandet ist: %2</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PresenterWindow</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>The next view</source>
        <translation>Die nächste Ansicht</translation>
    </message>
    <message>
        <source>This is the last view</source>
        <translation>Das ist die letzte Ansicht</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <comment>the time of day, how long the presentation has taken</comment>
        <translation>%1   %2</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PresetPanel</name>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>These in detail, everything else by what it is to them</source>
        <translation>Diese in allen Einzelheiten, alles andere nach dem, was es für sie ist</translation>
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
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>These as their outer edges alone</source>
        <translation>Diese nur mit ihren äußeren Rändern</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Ausgeblendet</translation>
    </message>
    <message>
        <source>Hides these</source>
        <translation>Blendet diese aus</translation>
    </message>
    <message>
        <source>My presets</source>
        <translation>Meine Vorgaben</translation>
    </message>
    <message>
        <source>Looks that you have named</source>
        <translation>Aussehen, das du benannt hast</translation>
    </message>
    <message>
        <source>&amp;Save This Look…</source>
        <translation>Dieses Aussehen &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Manage…</source>
        <translation>&amp;Verwalten …</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PrintProofDialog</name>
    <message>
        <source>in grey</source>
        <translation>in Grau</translation>
    </message>
    <message>
        <source>with protanopia</source>
        <translation>mit Protanopie</translation>
    </message>
    <message>
        <source>with deuteranopia</source>
        <translation>mit Deuteranopie</translation>
    </message>
    <message>
        <source>with tritanopia</source>
        <translation>mit Tritanopie</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Neighbours that look alike</source>
        <translation>Nachbarn, die gleich aussehen</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Look alike</source>
        <translation>Sehen gleich aus</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Was helfen würde</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>&amp;Also what looks alike on the screen</source>
        <translation>&amp;Auch, was auf dem Bildschirm gleich aussieht</translation>
    </message>
    <message>
        <source>&amp;With the changes</source>
        <translation>&amp;Mit den Änderungen</translation>
    </message>
    <message>
        <source>Make the &amp;Changes</source>
        <translation>Änderungen ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Print Proof</source>
        <translation>Druckprobe</translation>
    </message>
    <message>
        <source>Which may be meant: both kidneys have one colour</source>
        <translation>Was gewollt sein kann: beide Nieren haben eine Farbe</translation>
    </message>
    <message>
        <source>As it is seen</source>
        <translation>Wie es gesehen wird</translation>
    </message>
    <message>
        <source>Seen %1</source>
        <translation>Gesehen %1</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Looking at the picture…</source>
        <translation>Das Bild wird geprüft …</translation>
    </message>
    <message>
        <source>All neighbours can be told apart in grey and by all eyes.</source>
        <translation>Alle Nachbarn lassen sich in Grau und von allen Augen unterscheiden.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of neighbours look alike in print or to some eyes.</source>
        <translation>
            <numerusform>%n Paar Nachbarn sieht im Druck oder für manche Augen gleich aus.</numerusform>
            <numerusform>%n Paare von Nachbarn sehen im Druck oder für manche Augen gleich aus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n of them no change was found.</source>
        <translation>
            <numerusform>Für %n davon wurde keine Änderung gefunden.</numerusform>
            <numerusform>Für %n davon wurde keine Änderung gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
</context>
<context>
    <name>sline::widgets::RangeBox</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
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
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the unsaved work on “%1”?</source>
        <translation>Ungespeicherte Arbeit an „%1“ löschen?</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Sie lässt sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>%1, in an unknown folder</source>
        <translation>%1, in einem unbekannten Ordner</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SavePresetDialog</name>
    <message>
        <source>Save Preset</source>
        <translation>Vorgabe speichern</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>What it keeps of the look:</source>
        <translation>Was sie vom Aussehen behält:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ScaleBarMark</name>
    <message>
        <source>Scale: %1</source>
        <translation>Maßstab: %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionActions</name>
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
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittal</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Koronal</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Axial</translation>
    </message>
    <message>
        <source>%1 cannot be added: a structure can have %2 sections at most</source>
        <translation>%1 lässt sich nicht hinzufügen: eine Struktur kann höchstens %2 Schnitte haben</translation>
    </message>
    <message>
        <source>Take another section away first</source>
        <translation>Nimm zuerst einen anderen Schnitt weg</translation>
    </message>
    <message>
        <source>Of %1 alone</source>
        <translation>Nur von %1</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>&amp;Quer zum Blick</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionList</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schneidet</translation>
    </message>
    <message>
        <source>Rename Section</source>
        <translation>Schnitt umbenennen</translation>
    </message>
    <message>
        <source>Section On</source>
        <translation>Schnitt ein</translation>
    </message>
    <message>
        <source>Section Off</source>
        <translation>Schnitt aus</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionTool</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Flip Section</source>
        <translation>Schnitt umdrehen</translation>
    </message>
    <message>
        <source>Tilt Section</source>
        <translation>Schnitt kippen</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Schnitt verschieben</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionsPanel</name>
    <message>
        <source>Sections</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Add a section plane</source>
        <translation>Eine Schnittebene hinzufügen</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Keep the other side of this section</source>
        <translation>Die andere Seite dieses Schnitts behalten</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take this section away</source>
        <translation>Diesen Schnitt wegnehmen</translation>
    </message>
    <message>
        <source>Flip Section</source>
        <translation>Schnitt umdrehen</translation>
    </message>
    <message>
        <source>Towards the left, the back or the head; of an oblique section along its normal</source>
        <translation>Nach links, hinten oder zum Kopf; bei einem schrägen Schnitt entlang seiner Normalen</translation>
    </message>
    <message>
        <source>Hatched cut faces</source>
        <translation>Schraffierte Schnittflächen</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Hatched Cut Faces</source>
        <translation>Schraffierte Schnittflächen</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Lage</translation>
    </message>
    <message>
        <source>&amp;Cuts</source>
        <translation>Schn&amp;eidet</translation>
    </message>
    <message>
        <source>Delete Section</source>
        <translation>Schnitt löschen</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Gewählt: %1</translation>
    </message>
    <message>
        <source>What a Section Cuts</source>
        <translation>Was ein Schnitt schneidet</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Cut faces as white as the paper, in a tint of the structure&apos;s colour, or with the pattern of its tissue as in printed atlases</source>
        <translation>Schnittflächen so weiß wie das Papier, in einer Tönung der Farbe der Struktur oder mit dem Muster ihres Gewebes wie in gedruckten Atlanten</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Schnittflächen</translation>
    </message>
    <message>
        <source>Cut Faces</source>
        <translation>Schnittflächen</translation>
    </message>
    <message>
        <source>Along the X, the Y or the Z axis; of an oblique section along its normal</source>
        <translation>Entlang der X-, der Y- oder der Z-Achse; bei einem schrägen Schnitt entlang seiner Normalen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SelectionPanel</name>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>Far&amp;be …</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Koordinatensystem</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Einheit</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>Fewer &amp;triangles</source>
        <translation>Weniger &amp;Dreiecke</translation>
    </message>
    <message>
        <source>As for all</source>
        <translation>Wie für alle</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Verschieden</translation>
    </message>
    <message numerus="yes">
        <source>For the selected %n structures</source>
        <translation>
            <numerusform>Für die gewählte Struktur</numerusform>
            <numerusform>Für die gewählten %n Strukturen</numerusform>
        </translation>
    </message>
    <message>
        <source>Select structures to treat them unlike the others</source>
        <translation>Wähle Strukturen, um sie anders zu behandeln als die übrigen</translation>
    </message>
    <message>
        <source>For “%1”</source>
        <translation>Für „%1“</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
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
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n items</source>
        <translation>
            <numerusform>%1 von %n Element</numerusform>
            <numerusform>%1 von %n Elementen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>One of them has reached the end, and all keep their differences. A drag with Shift makes them equal.</source>
        <translation>Eine ist am Ende angekommen, und alle behalten ihre Unterschiede. Ziehen mit Umschalt macht sie gleich.</translation>
    </message>
    <message>
        <source>Structures that differ keep their differences; with Shift all become equal</source>
        <translation>Strukturen, die sich unterscheiden, behalten ihre Unterschiede; mit Umschalt werden alle gleich</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>Nobody has said how long the unit of its files is, and not all has the size that it should have: lengths stand with a “?”</source>
        <translation>Niemand hat gesagt, wie lang die Einheit der Dateien ist, und nicht alles hat die Größe, die es haben sollte: Längen stehen mit „?“</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SidesActions</name>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Sides are right</source>
        <translation>Seiten stimmen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Später fragen</translation>
    </message>
    <message>
        <source>Ask later: the menu Edit has the same answers</source>
        <translation>Später fragen: Das Menü Bearbeiten hat dieselben Antworten</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>Turn about the body&apos;s axis</source>
        <translation>Um die Körperachse drehen</translation>
    </message>
    <message>
        <source>Left and right are not certain: names or places contradict the frame.</source>
        <translation>Links und rechts sind nicht sicher: Namen oder Orte widersprechen dem Koordinatensystem.</translation>
    </message>
    <message>
        <source>Left and right are not certain: they were assumed.</source>
        <translation>Links und rechts sind nicht sicher: Sie wurden angenommen.</translation>
    </message>
    <message>
        <source>Read as %1 (%2).</source>
        <translation>Gelesen als %1 (%2).</translation>
    </message>
    <message>
        <source>Front and back are not certain: names tell left and right alone.</source>
        <translation>Vorn und hinten sind nicht sicher: Namen nennen nur links und rechts.</translation>
    </message>
    <message>
        <source>Names are right</source>
        <translation>Namen stimmen</translation>
    </message>
    <message>
        <source>Labels show such names with a question mark, and no question asks for them.</source>
        <translation>Beschriftungen zeigen solche Namen mit einem Fragezeichen, und keine Frage fragt danach.</translation>
    </message>
    <message>
        <source>Nothing tells that z leads to the head; it was assumed.</source>
        <translation>Nichts sagt, dass z zum Kopf führt; es wurde angenommen.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StageButton</name>
    <message>
        <source>%1, Γ %2</source>
        <translation>%1, Γ %2</translation>
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
    <message>
        <source>Drawing Style for What Is Opened Next</source>
        <translation>Zeichenstil für das, was als Nächstes geöffnet wird</translation>
    </message>
    <message>
        <source>Demos and scene files keep their own</source>
        <translation>Demos und Szenendateien behalten ihren eigenen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureActions</name>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureDelegate</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureProperties</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>Authors</source>
        <translation>Urheber</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Whose work the surface is; exports print it where you wish</source>
        <translation>Wessen Werk die Fläche ist; Exporte drucken es, wo du es wünschst</translation>
    </message>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>Say Whose Work It Is</source>
        <translation>Sagen, wessen Werk es ist</translation>
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
    <message>
        <source>No structure is called so</source>
        <translation>Keine Struktur heißt so</translation>
    </message>
    <message numerus="yes">
        <source>%n structures – Enter selects them</source>
        <translation>
            <numerusform>%n Struktur – Eingabe wählt sie</numerusform>
            <numerusform>%n Strukturen – Eingabe wählt sie</numerusform>
        </translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either. Enter selects all that match, Down goes to the list, Escape shows all again.</source>
        <translation>Wörter in beliebiger Reihenfolge; „%1“ oder ein Komma dazwischen findet das eine wie das andere. Eingabe wählt alle passenden, Pfeil ab führt in die Liste, Esc zeigt wieder alle.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeModel</name>
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
    <message>
        <source>%1, its own</source>
        <translation>%1, eigenes</translation>
    </message>
    <message>
        <source>Colour, its own</source>
        <translation>Farbe, eigene</translation>
    </message>
    <message>
        <source>Colours of what is in it</source>
        <translation>Farben dessen, was darin ist</translation>
    </message>
    <message>
        <source>Colour, from the group above</source>
        <translation>Farbe, von der Gruppe darüber</translation>
    </message>
    <message>
        <source>opacity %1 %, its own</source>
        <translation>Deckkraft %1 %, eigene</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>Deckkraft %1 %</translation>
    </message>
    <message>
        <source>Not locked</source>
        <translation>Nicht gesperrt</translation>
    </message>
    <message>
        <source>Locked by the group above: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Durch die Gruppe darüber gesperrt: behält Aussehen, Namen und Platz und lässt sich im Bild nicht anklicken</translation>
    </message>
    <message>
        <source>Locked: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Gesperrt: behält Aussehen, Namen und Platz und lässt sich im Bild nicht anklicken</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1: lies on the other side than its name says</source>
        <translation>%1: liegt auf der anderen Seite, als der Name sagt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeView</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleActions</name>
    <message>
        <source>Paste Style</source>
        <translation>Stil einfügen</translation>
    </message>
    <message>
        <source>Paste Style, Keep Colour</source>
        <translation>Stil einfügen, Farbe behalten</translation>
    </message>
    <message>
        <source>Make Like</source>
        <translation>Machen wie</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleChoiceEditor</name>
    <message>
        <source>Several</source>
        <translation>Verschiedene</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleColourEditor</name>
    <message>
        <source>Several</source>
        <translation>Mehrere</translation>
    </message>
    <message>
        <source>With the background</source>
        <translation>Mit dem Hintergrund</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleEditor</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>As the group above, or the usual, says</source>
        <translation>Wie die Gruppe darüber oder das Übliche sagt</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SubjectPopup</name>
    <message>
        <source>Working out other plates…</source>
        <translation>Andere Tafeln werden erarbeitet …</translation>
    </message>
    <message>
        <source>Other subjects</source>
        <translation>Andere Themen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdEditor</name>
    <message>
        <source>Thresholds of lines</source>
        <translation>Schwellen der Linien</translation>
    </message>
    <message>
        <source>How strong lines must be for their technique to draw them</source>
        <translation>Wie stark Linien sein müssen, damit ihre Technik sie zeichnet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdPanel</name>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Contrast vessels</source>
        <translation>Gefäße mit Kontrastmittel</translation>
    </message>
    <message>
        <source>&amp;Keep the scan with the scene (for slices)</source>
        <translation>Aufnahme mit der Szene auf&amp;bewahren (für Schnitte)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slice through the middle</source>
        <translation>Axialer, koronarer und sagittaler Schnitt durch die Mitte</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Name der Struktur</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>t&amp;o</source>
        <translation>b&amp;is</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HE</translation>
    </message>
    <message>
        <source>No structure is made of the scan yet</source>
        <translation>Aus der Aufnahme ist noch keine Struktur gemacht</translation>
    </message>
    <message>
        <source>Made of scans: %1</source>
        <translation>Aus Aufnahmen gemacht: %1</translation>
    </message>
    <message>
        <source>&amp;Add structure</source>
        <translation>Struktur h&amp;inzufügen</translation>
    </message>
    <message>
        <source>&amp;Add another structure</source>
        <translation>Weitere Struktur h&amp;inzufügen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::TourActions</name>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewActions</name>
    <message>
        <source>Key Light</source>
        <translation>Hauptlicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewCard</name>
    <message>
        <source>Name of the view</source>
        <translation>Name der Ansicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewList</name>
    <message numerus="yes">
        <source>%n of the structures and labels it shows are no longer in the scene</source>
        <translation>
            <numerusform>%n der Strukturen und Beschriftungen, die sie zeigt, gibt es in der Szene nicht mehr</numerusform>
            <numerusform>%n der Strukturen und Beschriftungen, die sie zeigt, gibt es in der Szene nicht mehr</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewRow</name>
    <message>
        <source>Saved views</source>
        <translation>Gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>A view keeps what you see: camera, what is shown, Γ, colours and sections</source>
        <translation>Eine Ansicht behält, was du siehst: Kamera, was gezeigt wird, Γ, Farben und Schnitte</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewTour</name>
    <message>
        <source>View “%1”</source>
        <translation>Ansicht „%1“</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Add View</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Update View “%1”</source>
        <translation>Ansicht „%1“ aktualisieren</translation>
    </message>
    <message>
        <source>Delete View “%1”</source>
        <translation>Ansicht „%1“ löschen</translation>
    </message>
    <message>
        <source>Rename View</source>
        <translation>Ansicht umbenennen</translation>
    </message>
    <message>
        <source>Move View</source>
        <translation>Ansicht verschieben</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewWordsEditor</name>
    <message>
        <source>What is to be read with the view</source>
        <translation>Was mit der Ansicht zu lesen ist</translation>
    </message>
    <message>
        <source>Notes for who presents the view</source>
        <translation>Notizen für den, der die Ansicht vorführt</translation>
    </message>
    <message>
        <source>For you alone, while you present: no file for others has them</source>
        <translation>Für dich allein, während du vorführst: Keine Datei für andere hat sie</translation>
    </message>
    <message>
        <source>Title of the view</source>
        <translation>Titel der Ansicht</translation>
    </message>
    <message>
        <source>What the view is called where it is shown, if that is not its name</source>
        <translation>Wie die Ansicht heißt, wo sie gezeigt wird, wenn das nicht ihr Name ist</translation>
    </message>
    <message>
        <source>How long the view is shown</source>
        <translation>Wie lange die Ansicht gezeigt wird</translation>
    </message>
    <message>
        <source>How long a film rests at the view; 0 for as long as at the others</source>
        <translation>Wie lange ein Film bei der Ansicht rastet; 0 für so lange wie bei den anderen</translation>
    </message>
    <message>
        <source> s</source>
        <comment>seconds</comment>
        <translation> s</translation>
    </message>
    <message>
        <source>as others</source>
        <comment>how long a view is shown</comment>
        <translation>wie andere</translation>
    </message>
    <message>
        <source>Change What a View Says</source>
        <translation>Ändern, was eine Ansicht sagt</translation>
    </message>
    <message>
        <source>Choose a view</source>
        <translation>Wähle eine Ansicht</translation>
    </message>
    <message>
        <source>Text, to be read with the view</source>
        <translation>Text, mit der Ansicht zu lesen</translation>
    </message>
    <message>
        <source>Notes, for who presents it</source>
        <translation>Notizen, für den, der vorführt</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>For who does not see the picture: files for others have it, and without it they say what is seen</source>
        <translation>Für wen das Bild nicht zu sehen ist: Dateien für andere haben es, und ohne es sagen sie, was zu sehen ist</translation>
    </message>
    <message>
        <source>Description, for who does not see it</source>
        <translation>Beschreibung, für wen es nicht zu sehen ist</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewsPanel</name>
    <message>
        <source>Update View</source>
        <translation>Ansicht aktualisieren</translation>
    </message>
    <message>
        <source>The chosen view shows from now on what is seen now</source>
        <translation>Die gewählte Ansicht zeigt von jetzt an, was jetzt zu sehen ist</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take the chosen view away</source>
        <translation>Die gewählte Ansicht wegnehmen</translation>
    </message>
    <message>
        <source>Text, Notes</source>
        <translation>Text, Notizen</translation>
    </message>
    <message>
        <source>Show what the chosen view says, to be typed below</source>
        <translation>Zeigen, was die gewählte Ansicht sagt, um es darunter zu tippen</translation>
    </message>
</context>
</TS>
