<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nb_NO" sourcelanguage="en">
<context>
    <name>Told</name>
    <message>
        <source>line %1</source>
        <translation>linje %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>byte %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>hjørne %1</translation>
    </message>
    <message>
        <source>vertex %1 in %2</source>
        <translation>hjørne %1 i %2</translation>
    </message>
    <message>
        <source>it cannot be written: %1</source>
        <translation>kan ikke skrives: %1</translation>
    </message>
    <message>
        <source>it cannot be put in its place: %1</source>
        <translation>kan ikke settes på plass: %1</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>kan ikke leses: %1</translation>
    </message>
    <message>
        <source>its folder cannot be written to: %1</source>
        <translation>det kan ikke skrives i mappen: %1</translation>
    </message>
    <message>
        <source>it is open for writing in %1</source>
        <translation>er åpen for skriving i: %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>et annet program</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>er en mappe</translation>
    </message>
    <message>
        <source>%1; the file that was there is whole, as it was</source>
        <translation>%1; filen som var der, er uskadd</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>er større enn %1 byte</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>mappen kan ikke lages: %1</translation>
    </message>
    <message>
        <source>it is a file, and a folder is to be made</source>
        <translation>er en fil, og det skal lages en mappe</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>mappen kan ikke leses: %1</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>mappen er ikke tom</translation>
    </message>
    <message>
        <source>no temporary folder can be made here: %1</source>
        <translation>her kan det ikke lages noen midlertidig mappe: %1</translation>
    </message>
    <message>
        <source>Choose a folder that exists and that you may write to</source>
        <translation>Velg en mappe som finnes og som du kan skrive i</translation>
    </message>
    <message>
        <source>Choose a place that exists and that you may write to</source>
        <translation>Velg et sted som finnes og der du kan skrive</translation>
    </message>
    <message>
        <source>Free some space on the disk, or choose another one</source>
        <translation>Frigjør plass på disken, eller velg en annen</translation>
    </message>
    <message>
        <source>Free some space on its disk</source>
        <translation>Frigjør plass på disken</translation>
    </message>
    <message>
        <source>Check the rights of its folder</source>
        <translation>Kontroller rettighetene til mappen</translation>
    </message>
    <message>
        <source>Check the name and the rights</source>
        <translation>Kontroller navn og rettigheter</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>Angi en fil</translation>
    </message>
    <message>
        <source>Name the right file</source>
        <translation>Angi den riktige filen</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet</source>
        <translation>Angi en mappe som ikke finnes ennå</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet, or an empty one</source>
        <translation>Angi en mappe som ikke finnes ennå eller er tom</translation>
    </message>
    <message>
        <source>Save it under another name or in another folder</source>
        <translation>Lagre under et annet navn eller i en annen mappe</translation>
    </message>
    <message>
        <source>Close it there, or save it under another name</source>
        <translation>Lukk den der, eller lagre under et annet navn</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Lagre under et annet navn</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>er tom</translation>
    </message>
    <message>
        <source>it is no whole ZIP file: %1</source>
        <translation>er ingen hel ZIP-fil: %1</translation>
    </message>
    <message>
        <source>it is cut or damaged</source>
        <translation>er avkuttet eller skadd</translation>
    </message>
    <message>
        <source>it holds no scene.json: it is a ZIP file, but no scene</source>
        <translation>inneholder ingen scene.json: en ZIP-fil, men ingen scene</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>er for stor</translation>
    </message>
    <message>
        <source>a newer version of the program has written it, with more than this one would write</source>
        <translation>en nyere versjon av programmet har skrevet den, med mer enn denne ville skrive</translation>
    </message>
    <message>
        <source>it was damaged, and holds no state of the scene that is whole</source>
        <translation>var skadd og inneholder ingen hel tilstand av scenen</translation>
    </message>
    <message>
        <source>Open an older copy of it, or import the meshes again</source>
        <translation>Åpne en eldre kopi, eller importer nettene på nytt</translation>
    </message>
    <message>
        <source>Open the scene file as it was saved last</source>
        <translation>Åpne scenefilen slik den sist ble lagret</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>denne filen finnes ikke</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>denne filen eller mappen finnes ikke</translation>
    </message>
    <message>
        <source>is a folder, not a mesh file</source>
        <translation>er en mappe, ikke en nettfil</translation>
    </message>
    <message>
        <source>is a device or pipe, not a file</source>
        <translation>er en enhet eller et rør, ikke en fil</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kan ikke åpnes: %1</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>er tom</translation>
    </message>
    <message>
        <source>its size cannot be found: %1</source>
        <translation>størrelsen lar seg ikke finne: %1</translation>
    </message>
    <message>
        <source>has %1 bytes, the limit is %2</source>
        <translation>har %1 byte, grensen er %2</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory</source>
        <translation>trenger %1 byte minne</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory when unpacked</source>
        <translation>trenger %1 byte minne utpakket</translation>
    </message>
    <message>
        <source>cannot be read any further</source>
        <translation>kan ikke leses lenger</translation>
    </message>
    <message>
        <source>its packed bytes end in the middle</source>
        <translation>de pakkede bytene slutter midt i</translation>
    </message>
    <message>
        <source>holds nothing when unpacked</source>
        <translation>inneholder ingenting utpakket</translation>
    </message>
    <message>
        <source>this kind of file is not supported</source>
        <translation>denne typen fil støttes ikke</translation>
    </message>
    <message>
        <source>has no extension that tells its kind</source>
        <translation>har ingen endelse som sier hva slags fil det er</translation>
    </message>
    <message>
        <source>files of kind &apos;%1&apos; are not supported</source>
        <translation>filer av typen «%1» støttes ikke</translation>
    </message>
    <message>
        <source>%1; its content looks like %2</source>
        <translation>%1; innholdet ser ut som: %2</translation>
    </message>
    <message>
        <source>the folder holds no mesh</source>
        <translation>mappen inneholder ikke noe nett</translation>
    </message>
    <message>
        <source>%1 is an archive and was not looked into</source>
        <translation>%1 er et arkiv som det ikke ble sett inn i</translation>
    </message>
    <message>
        <source>%1 are archives and were not looked into</source>
        <translation>%1 er arkiver som det ikke ble sett inn i</translation>
    </message>
    <message>
        <source>is an archive, which is not looked into</source>
        <translation>er et arkiv, som det ikke ses inn i</translation>
    </message>
    <message>
        <source>Unpack it and open what was in it</source>
        <translation>Pakk det ut og åpne det som var i det</translation>
    </message>
    <message>
        <source>Open a bundle of 3D Slicer (.mrb) by itself; unpack any other and open what was in it</source>
        <translation>Åpne en pakke fra 3D Slicer (.mrb) for seg; pakk ut alle andre og åpne det som var i dem</translation>
    </message>
    <message>
        <source>the scene holds no model</source>
        <translation>scenen inneholder ingen modell</translation>
    </message>
    <message>
        <source>none of the scene&apos;s %1 model files can be found</source>
        <translation>ingen av scenens %1 modellfiler er å finne</translation>
    </message>
    <message>
        <source>there is nothing to read</source>
        <translation>det er ingenting å lese</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>importen ble avbrutt</translation>
    </message>
    <message>
        <source>all structures are left out</source>
        <translation>alle strukturer er utelatt</translation>
    </message>
    <message>
        <source>nothing is made of the scan yet</source>
        <translation>det er ikke laget noe av skanningen ennå</translation>
    </message>
    <message>
        <source>holds no triangles</source>
        <translation>inneholder ingen trekanter</translation>
    </message>
    <message>
        <source>holds no vertices</source>
        <translation>inneholder ingen hjørner</translation>
    </message>
    <message>
        <source>holds vertices but no faces</source>
        <translation>inneholder hjørner, men ingen flater</translation>
    </message>
    <message>
        <source>holds no faces, only lines or points</source>
        <translation>inneholder ingen flater, bare linjer eller punkter</translation>
    </message>
    <message>
        <source>this is not a statement of an OBJ file</source>
        <translation>dette er ingen setning i en OBJ-fil</translation>
    </message>
    <message>
        <source>Check that the file is an OBJ file</source>
        <translation>Kontroller at filen er en OBJ-fil</translation>
    </message>
    <message>
        <source>Export the mesh as a surface with faces</source>
        <translation>Eksporter nettet som en overflate med flater</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;ply&apos;</source>
        <translation>filen begynner ikke med «ply»</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;OFF&apos;</source>
        <translation>filen begynner ikke med «OFF»</translation>
    </message>
    <message>
        <source>%1 stands where %2 should</source>
        <translation>%1 står der %2 skulle stått</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>filen slutter etter %1</translation>
    </message>
    <message>
        <source>the file ends within a face</source>
        <translation>filen slutter midt i en flate</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles are more than the limit</source>
        <translation>%1 hjørner og %2 trekanter er mer enn grensen</translation>
    </message>
    <message>
        <source>%1 of %2 faces refer to vertices that do not exist (there are %3 vertices)</source>
        <translation>%1 av %2 flater viser til hjørner som ikke finnes (det er %3 hjørner)</translation>
    </message>
    <message>
        <source>%1 of %2 vertices are not finite numbers</source>
        <translation>%1 av %2 hjørner er ikke endelige tall</translation>
    </message>
    <message>
        <source>the reader of %1 files crashed over this file (%2)</source>
        <translation>leseren av %1-filer krasjet på denne filen (%2)</translation>
    </message>
    <message>
        <source>the reader of %1 files wanted more than %2 of memory for this file</source>
        <translation>leseren av %1-filer ville ha mer enn %2 minne til denne filen</translation>
    </message>
    <message>
        <source>the reader of %1 files did not come to an end within %2 s of computing</source>
        <translation>leseren av %1-filer ble ikke ferdig på %2 s regnetid</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>det er ikke nok minne</translation>
    </message>
    <message>
        <source>a library failed: %1</source>
        <translation>et bibliotek feilet: %1</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Kontroller navnet</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Kontroller stien</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Kontroller disken</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Kontroller rettighetene</translation>
    </message>
    <message>
        <source>Check the disk or copy the file again</source>
        <translation>Kontroller disken, eller kopier filen på nytt</translation>
    </message>
    <message>
        <source>Copy the file again</source>
        <translation>Kopier filen på nytt</translation>
    </message>
    <message>
        <source>Copy the data to a file</source>
        <translation>Kopier dataene til en fil</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Lukk andre programmer</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Lukk andre programmer og prøv igjen</translation>
    </message>
    <message>
        <source>Reduce the mesh</source>
        <translation>Reduser nettet</translation>
    </message>
    <message>
        <source>Name a file inside it</source>
        <translation>Angi en fil i den</translation>
    </message>
    <message>
        <source>Name a mesh, a folder or a scene</source>
        <translation>Angi et nett, en mappe eller en scene</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Mulige er %1</translation>
    </message>
    <message>
        <source>%1, many of them packed (.gz) too</source>
        <translation>%1, mange av dem også pakket (.gz)</translation>
    </message>
    <message>
        <source>Give a file of surfaces (%1), a folder of them, a 3D Slicer scene (.mrml, .mrb) or its fiducials (%2), or a scene file (.sline)</source>
        <translation>Mulige er en fil med flater (%1), en mappe med slike, en scene fra 3D Slicer (.mrml, .mrb) eller dens merker (%2), eller en scenefil (.sline)</translation>
    </message>
    <message>
        <source>Export the mesh again from the program that made it</source>
        <translation>Eksporter nettet på nytt fra programmet som laget det</translation>
    </message>
    <message>
        <source>Export the mesh as a surface of triangles</source>
        <translation>Eksporter nettet som en flate av trekanter</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind or export the mesh again</source>
        <translation>Gi filen endelsen til sin type, eller eksporter nettet på nytt</translation>
    </message>
    <message>
        <source>It may be damaged: export it again, or in another format</source>
        <translation>Den er kanskje skadd: eksporter den på nytt, eller i et annet format</translation>
    </message>
    <message>
        <source>Keep the scene beside its model files, or save it again with its models</source>
        <translation>La scenen stå ved modellfilene sine, eller lagre den på nytt med modellene</translation>
    </message>
    <message>
        <source>None of the files could be read</source>
        <translation>Ingen av filene kunne leses</translation>
    </message>
    <message>
        <source>Include at least one</source>
        <translation>Ta med minst én</translation>
    </message>
    <message>
        <source>Make a structure of it by a threshold, or keep it with the scene</source>
        <translation>Lag en struktur av den med en terskel, eller behold den med scenen</translation>
    </message>
    <message>
        <source>%1; they are left out</source>
        <translation>%1; de er utelatt</translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation>%1; utelatt</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>utelatt: %1</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <translation>%1 ble utelatt: %2</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>ingen trekanter</translation>
    </message>
    <message>
        <source>no triangles in %1</source>
        <translation>ingen trekanter i %1</translation>
    </message>
    <message>
        <source>%1 of %2 faces have fewer than three corners and are left out</source>
        <translation>%1 av %2 flater har færre enn tre hjørner og er utelatt</translation>
    </message>
    <message>
        <source>%1 (the first: %2); they and the %3 triangles that use them are left out</source>
        <translation>%1 (det første: %2); de og de %3 trekantene som bruker dem, er utelatt</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surface: %3 left out</source>
        <translation>%1 av %2 flate reparert: %3 utelatt</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surfaces: %3 left out</source>
        <translation>%1 av %2 flater reparert: %3 utelatt</translation>
    </message>
    <message>
        <source>%1 face given twice</source>
        <translation>%1 dobbel flate</translation>
    </message>
    <message>
        <source>%1 faces given twice</source>
        <translation>%1 doble flater</translation>
    </message>
    <message>
        <source>%1 face without area</source>
        <translation>%1 flate uten areal</translation>
    </message>
    <message>
        <source>%1 faces without area</source>
        <translation>%1 flater uten areal</translation>
    </message>
    <message>
        <source>%1 face given twice, %2 without area</source>
        <translation>%1 dobbel flate, %2 uten areal</translation>
    </message>
    <message>
        <source>%1 faces given twice, %2 without area</source>
        <translation>%1 doble flater, %2 uten areal</translation>
    </message>
    <message>
        <source>a piece of %1 has no consistent orientation; it stays as it is</source>
        <translation>et stykke av %1 har ingen entydig orientering; det blir som det er</translation>
    </message>
    <message>
        <source>%1 has no face with area; left out</source>
        <translation>%1 har ingen flate med areal; utelatt</translation>
    </message>
    <message>
        <source>its file has changed or is gone</source>
        <translation>filen er endret eller borte</translation>
    </message>
    <message>
        <source>no threshold made a structure: no scan was read that has it</source>
        <translation>ingen terskel ga en struktur: det er ikke lest noen skanning som har den</translation>
    </message>
    <message>
        <source>the folder could not be read to its end: %1</source>
        <translation>mappen kunne ikke leses til ende: %1</translation>
    </message>
    <message>
        <source>the folder was not searched to its end: %1</source>
        <translation>mappen ble ikke gjennomsøkt til ende: %1</translation>
    </message>
    <message>
        <source>it holds too many files</source>
        <translation>den inneholder for mange filer</translation>
    </message>
    <message>
        <source>the file is absent; it was left out</source>
        <translation>filen mangler; den ble utelatt</translation>
    </message>
    <message>
        <source>the scene refers to a place outside its folder; it was left out</source>
        <translation>scenen viser til et sted utenfor mappen sin; det ble utelatt</translation>
    </message>
    <message>
        <source>a scene file is in millimetres of the patient&apos;s frame; the frame and the unit that were chosen do not apply to it</source>
        <translation>en scenefil er i millimeter i pasientens aksesystem; valgt system og enhet gjelder ikke for den</translation>
    </message>
    <message>
        <source>surfaces of a scene file keep their triangles; only what is imported is decimated</source>
        <translation>flater i en scenefil beholder trekantene sine; bare det som importeres, forenkles</translation>
    </message>
    <message>
        <source>%1 structure left out that the folder also holds as surfaces</source>
        <translation>%1 struktur utelatt som mappen også har som flater</translation>
    </message>
    <message>
        <source>%1 structures left out that the folder also holds as surfaces</source>
        <translation>%1 strukturer utelatt som mappen også har som flater</translation>
    </message>
    <message>
        <source>a scan, of which a threshold can make a structure: %1</source>
        <translation>en skanning som en terskel kan lage en struktur av: %1</translation>
    </message>
    <message>
        <source>the scan cannot be kept: %1</source>
        <translation>skanningen kan ikke beholdes: %1</translation>
    </message>
    <message>
        <source>%1 holds no segmentation</source>
        <translation>%1 inneholder ingen segmentering</translation>
    </message>
    <message>
        <source>%1 hold no segmentation</source>
        <translation>%1 inneholder ingen segmentering</translation>
    </message>
    <message>
        <source>%1 line and point elements are left out; only faces are read</source>
        <translation>%1 linjer og punkter er utelatt; bare flater leses</translation>
    </message>
    <message>
        <source>%1 statements are unknown and left out (the first: %2)</source>
        <translation>%1 setninger er ukjente og utelatt (den første: %2)</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle of the %2 promised are ignored</source>
        <translation>%1 byte etter den siste av de %2 lovede trekantene er oversett</translation>
    </message>
    <message>
        <source>has neither sform nor qform: which side is left is taken from names, if they tell</source>
        <translation>har verken sform eller qform: hvilken side som er venstre, tas fra navnene, om de sier det</translation>
    </message>
    <message>
        <source>holds %1 images of one place; the first was read</source>
        <translation>inneholder %1 bilder av ett sted; det første ble lest</translation>
    </message>
    <message>
        <source>intensities were rounded to 16 bits, by at most %1</source>
        <translation>intensiteter ble avrundet til 16 biter, med høyst %1</translation>
    </message>
    <message>
        <source>%1 masks hold nothing and were left out: %2</source>
        <translation>%1 masker inneholder ingenting og ble utelatt: %2</translation>
    </message>
    <message>
        <source>%1 atom without coordinates left out</source>
        <translation>%1 atom uten koordinater utelatt</translation>
    </message>
    <message>
        <source>%1 atoms without coordinates left out</source>
        <translation>%1 atomer uten koordinater utelatt</translation>
    </message>
    <message>
        <source>%1 further model left out; the first is drawn</source>
        <translation>%1 annen modell utelatt; den første er tegnet</translation>
    </message>
    <message>
        <source>%1 further models left out; the first is drawn</source>
        <translation>%1 andre modeller utelatt; den første er tegnet</translation>
    </message>
    <message>
        <source>chain %1 laid over chain %2 of %3: %4 of %5 pairs of residues, %6 % identical, RMSD %7</source>
        <translation>kjede %1 lagt over kjede %2 i %3: %4 av %5 par av rester, %6 % like, RMSD %7</translation>
    </message>
    <message>
        <source>not laid over %1, since no chains match; it stays where its file has it</source>
        <translation>ikke lagt over %1, siden ingen kjeder passer; blir der filen har den</translation>
    </message>
    <message>
        <source>no file of this name was found</source>
        <translation>det ble ikke funnet noen fil med dette navnet</translation>
    </message>
    <message>
        <source>only files that other structures came from were found</source>
        <translation>bare filer som andre strukturer kom fra, ble funnet</translation>
    </message>
    <message>
        <source>there are %1 files of this name; name the folder of the one that is meant</source>
        <translation>det er %1 filer med dette navnet; angi mappen til den som menes</translation>
    </message>
    <message>
        <source>structures from several files of this name are in the scene</source>
        <translation>i scenen er det strukturer fra flere filer med dette navnet</translation>
    </message>
    <message>
        <source>no structure of the scene came from these of its surfaces: %1</source>
        <translation>ingen struktur i scenen kom fra disse flatene: %1</translation>
    </message>
    <message>
        <source>it holds no surface %1 any more</source>
        <translation>inneholder ikke lenger noen flate %1</translation>
    </message>
    <message>
        <source>it has no face with area any more</source>
        <translation>har ikke lenger noen flate med areal</translation>
    </message>
    <message>
        <source>chosen by the user</source>
        <translation>valgt av deg</translation>
    </message>
    <message>
        <source>no header and no left/right names: LPS assumed</source>
        <translation>verken hode eller navn med side: LPS antatt</translation>
    </message>
    <message>
        <source>vote: %1 of %2 left/right names</source>
        <translation>avstemning: %1 av %2 navn med side</translation>
    </message>
    <message>
        <source>header: %1</source>
        <translation>filens hode: %1</translation>
    </message>
    <message>
        <source>coordinates left as they are</source>
        <translation>koordinater som de er</translation>
    </message>
    <message>
        <source>scene of Slicer: millimetres</source>
        <translation>scene fra Slicer: millimeter</translation>
    </message>
    <message>
        <source>no unit in the file: millimetres assumed</source>
        <translation>ingen enhet i filen: millimeter antatt</translation>
    </message>
    <message>
        <source>SPACE in the header</source>
        <translation>SPACE i hodet</translation>
    </message>
    <message>
        <source>SPACE in a comment</source>
        <translation>SPACE i en kommentar</translation>
    </message>
    <message>
        <source>SPACE in the field data</source>
        <translation>SPACE i feltdataene</translation>
    </message>
    <message>
        <source>SPACE in the title</source>
        <translation>SPACE i tittelen</translation>
    </message>
    <message>
        <source>DICOM: patient coordinates</source>
        <translation>DICOM: pasientens koordinater</translation>
    </message>
    <message>
        <source>DICOM: millimetres</source>
        <translation>DICOM: millimeter</translation>
    </message>
    <message>
        <source>glTF: metres</source>
        <translation>glTF: meter</translation>
    </message>
    <message>
        <source>header: millimetres</source>
        <translation>filens hode: millimeter</translation>
    </message>
    <message>
        <source>volumes are in millimetres</source>
        <translation>volumer er i millimeter</translation>
    </message>
    <message>
        <source>modelled in it</source>
        <translation>modellert i det</translation>
    </message>
    <message>
        <source>scene file</source>
        <translation>scenefil</translation>
    </message>
    <message>
        <source>a molecule has no left and right</source>
        <translation>et molekyl har verken venstre eller høyre</translation>
    </message>
    <message>
        <source>1 Å is drawn as 1 mm</source>
        <translation>1 Å er tegnet som 1 mm</translation>
    </message>
    <message>
        <source>the export was stopped</source>
        <translation>eksporten ble stoppet</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Eksporter på nytt</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large</source>
        <translation>et bilde på %1 piksler er for stort</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large for this kind of file</source>
        <translation>et bilde på %1 piksler er for stort for denne typen fil</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page; a side may have %1 pixels in this kind of file</source>
        <translation>Velg færre punkter per tomme eller en mindre side; en side kan ha %1 piksler i denne typen fil</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page, or PNG or TIFF; a picture may have %1 million pixels here</source>
        <translation>Velg færre punkter per tomme eller en mindre side, eller PNG eller TIFF; et bilde kan ha %1 millioner piksler her</translation>
    </message>
    <message>
        <source>the picture cannot be written: %1</source>
        <translation>bildet kan ikke skrives: %1</translation>
    </message>
    <message>
        <source>Choose a smaller picture or another kind of file</source>
        <translation>Velg et mindre bilde eller en annen type fil</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>det er for lite minne</translation>
    </message>
    <message>
        <source>the picture has no labels to ask for</source>
        <translation>bildet har ingen etiketter å spørre etter</translation>
    </message>
    <message>
        <source>Label structures, or choose a view that shows some</source>
        <translation>Sett etiketter på strukturer, eller velg en visning som viser noen</translation>
    </message>
    <message>
        <source>the scene needs more than the 4 GB that a GLB file may have</source>
        <translation>scenen trenger mer enn de 4 GB som en GLB-fil kan ha</translation>
    </message>
    <message>
        <source>Hide structures, or make them coarser</source>
        <translation>Skjul strukturer, eller gjør dem grovere</translation>
    </message>
    <message>
        <source>a film takes 0.1 to 600 seconds</source>
        <translation>en film varer 0,1 til 600 sekunder</translation>
    </message>
    <message>
        <source>Choose another length</source>
        <translation>Velg en annen lengde</translation>
    </message>
    <message>
        <source>a film has 1 to 60 frames per second</source>
        <translation>en film har 1 til 60 bilder per sekund</translation>
    </message>
    <message>
        <source>Choose another rate</source>
        <translation>Velg en annen takt</translation>
    </message>
    <message>
        <source>Save views, or make a turntable</source>
        <translation>Lagre visninger, eller lag en dreieskive</translation>
    </message>
    <message>
        <source>MP4 films are made by the program ffmpeg, which is not installed</source>
        <translation>MP4-filmer lages av programmet ffmpeg, som ikke er installert</translation>
    </message>
    <message>
        <source>Install ffmpeg, or write an animated WebP or GIF</source>
        <translation>Installer ffmpeg, eller skriv en animert WebP eller GIF</translation>
    </message>
    <message>
        <source>GIF films show at most 50 frames per second</source>
        <translation>GIF-filmer viser høyst 50 bilder per sekund</translation>
    </message>
    <message>
        <source>Choose 50 or fewer, or another kind of film</source>
        <translation>Velg 50 eller færre, eller en annen type film</translation>
    </message>
    <message>
        <source>the picture could not be drawn: %1</source>
        <translation>bildet kunne ikke tegnes: %1</translation>
    </message>
    <message>
        <source>Hide some structures, or close other programs to free memory</source>
        <translation>Skjul noen strukturer, eller lukk andre programmer for å frigjøre minne</translation>
    </message>
    <message>
        <source>the structures of this scene do not fit into the memory set aside for a picture, not even piece by piece</source>
        <translation>strukturene i denne scenen får ikke plass i minnet som er satt av til et bilde, ikke engang stykke for stykke</translation>
    </message>
    <message>
        <source>Hide some structures</source>
        <translation>Skjul noen strukturer</translation>
    </message>
    <message>
        <source>the driver %1 is too old: OpenGL 3.3 or OpenGL ES 3.0 is needed</source>
        <translation>driveren %1 er for gammel: OpenGL 3.3 eller OpenGL ES 3.0 trengs</translation>
    </message>
    <message>
        <source>Update the graphics driver, or install Mesa (libgl1-mesa-dri)</source>
        <translation>Oppdater grafikkdriveren, eller installer Mesa (libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>ingen tilgang</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>filen eller mappen finnes ikke</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>ingen plass igjen på disken</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>disken kan bare leses</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>er en mappe</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>er ingen mappe</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>feil ved lesing eller skriving</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>filen er for stor</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>for mange åpne filer</translation>
    </message>
    <message>
        <source>it is no scene of Sline</source>
        <translation>er ingen scene fra Sline</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>er kryptert</translation>
    </message>
    <message>
        <source>it cannot be unpacked: %1</source>
        <translation>kan ikke pakkes ut: %1</translation>
    </message>
    <message>
        <source>the unit of %1 has no length</source>
        <translation>enheten til %1 har ingen lengde</translation>
    </message>
    <message>
        <source>Choose a unit</source>
        <translation>Velg en enhet</translation>
    </message>
    <message>
        <source>the steps of smoothing of %1 are out of range</source>
        <translation>antallet glattingssteg for %1 er utenfor området</translation>
    </message>
    <message>
        <source>the bound for decimation of %1 is out of range</source>
        <translation>grensen for forenkling av %1 er utenfor området</translation>
    </message>
    <message>
        <source>Choose 0 to %1</source>
        <translation>Velg 0 til %1</translation>
    </message>
    <message>
        <source>the name of %1 is empty</source>
        <translation>navnet på %1 er tomt</translation>
    </message>
    <message>
        <source>Give it a name</source>
        <translation>Gi den et navn</translation>
    </message>
    <message>
        <source>Plan the import again</source>
        <translation>Planlegg importen på nytt</translation>
    </message>
    <message>
        <source>the reader of %1 files gave no answer for this file</source>
        <translation>leseren av %1-filer ga ikke noe svar for denne filen</translation>
    </message>
    <message>
        <source>the program that reads it gave no answer</source>
        <translation>programmet som leser den, ga ikke noe svar</translation>
    </message>
    <message>
        <source>there is no memory to read it</source>
        <translation>det er ikke minne til å lese den</translation>
    </message>
    <message>
        <source>reading was given up</source>
        <translation>lesingen ble gitt opp</translation>
    </message>
    <message>
        <source>%1 files are read by sline-reader, which is not beside Sline</source>
        <translation>%1-filer leses av sline-reader, som ikke ligger ved siden av Sline</translation>
    </message>
    <message>
        <source>Install Sline again</source>
        <translation>Installer Sline på nytt</translation>
    </message>
    <message>
        <source>Export the file again, or in another format</source>
        <translation>Eksporter filen på nytt, eller i et annet format</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>trenger mer minne enn det er</translation>
    </message>
    <message>
        <source>Import it again</source>
        <translation>Importer den på nytt</translation>
    </message>
    <message>
        <source>its packed bytes are damaged: they cannot be unpacked beyond byte %1</source>
        <translation>de pakkede bytene er skadd: de kan ikke pakkes ut forbi byte %1</translation>
    </message>
    <message>
        <source>too short for an STL file: not text, and its %1 bytes do not hold the header of 84</source>
        <translation>for kort for en STL-fil: ikke tekst, og %1 byte rommer ikke hodet på 84</translation>
    </message>
    <message>
        <source>the file neither begins with &apos;solid&apos; nor has the size of a binary STL file</source>
        <translation>filen begynner verken med «solid» eller har størrelsen til en binær STL-fil</translation>
    </message>
    <message>
        <source>Check that the file is an STL file</source>
        <translation>Kontroller at filen er en STL-fil</translation>
    </message>
    <message>
        <source>the header promises %1 triangles, the file ends after %2</source>
        <translation>hodet lover %1 trekanter, filen slutter etter %2</translation>
    </message>
    <message>
        <source>the file ends where %1 should follow</source>
        <translation>filen slutter der %1 skulle fulgt</translation>
    </message>
    <message>
        <source>has no element &apos;vertex&apos;</source>
        <translation>har ikke noe element «vertex»</translation>
    </message>
    <message>
        <source>holds points but no element &apos;face&apos; or &apos;tristrips&apos;</source>
        <translation>inneholder punkter, men ikke noe element «face» eller «tristrips»</translation>
    </message>
    <message>
        <source>the header has no &apos;end_header&apos;</source>
        <translation>hodet har ikke noe «end_header»</translation>
    </message>
    <message>
        <source>binary OFF is not supported</source>
        <translation>binær OFF støttes ikke</translation>
    </message>
    <message>
        <source>Export the mesh as text OFF</source>
        <translation>Eksporter nettet som OFF i tekst</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>et tall</translation>
    </message>
    <message>
        <source>the volume holds nothing but background</source>
        <translation>volumet inneholder ikke annet enn bakgrunn</translation>
    </message>
    <message>
        <source>Choose a volume with structures</source>
        <translation>Velg et volum med strukturer</translation>
    </message>
    <message>
        <source>the borders of its structures have more than %1</source>
        <translation>grensene til strukturene har mer enn %1</translation>
    </message>
    <message>
        <source>its structures have more than %1</source>
        <translation>strukturene har mer enn %1</translation>
    </message>
    <message>
        <source>Check that it is a label volume, or export it with larger voxels</source>
        <translation>Kontroller at det er et etikettvolum, eller eksporter det med større voksler</translation>
    </message>
    <message>
        <source>does not begin like a header of NIfTI or Analyze</source>
        <translation>begynner ikke som et hode av NIfTI eller Analyze</translation>
    </message>
    <message>
        <source>has %1 axes, a volume needs three</source>
        <translation>har %1 akser, et volum trenger tre</translation>
    </message>
    <message>
        <source>Export a volume with three axes in space</source>
        <translation>Eksporter et volum med tre akser i rommet</translation>
    </message>
    <message>
        <source>does not begin like a volume of FreeSurfer (MGH)</source>
        <translation>begynner ikke som et volum fra FreeSurfer (MGH)</translation>
    </message>
    <message>
        <source>Put both files into one folder, or export the volume as one .nii file</source>
        <translation>Legg begge filene i én mappe, eller eksporter volumet som én .nii-fil</translation>
    </message>
    <message>
        <source>is DICOM of a kind that is not known here and holds no segmentation</source>
        <translation>er DICOM av et slag som ikke er kjent her, og inneholder ingen segmentering</translation>
    </message>
    <message>
        <source>holds no segmentation: its content is of the kind %1</source>
        <translation>inneholder ingen segmentering: innholdet er av typen %1</translation>
    </message>
    <message>
        <source>Give the DICOM segmentation or RT structure set that was made from it</source>
        <translation>Åpne DICOM-segmenteringen eller RT-struktursettet som ble laget av den</translation>
    </message>
    <message>
        <source>Copy or export the file again; it is incomplete or damaged</source>
        <translation>Kopier eller eksporter filen på nytt; den er ufullstendig eller skadd</translation>
    </message>
    <message>
        <source>the file ends within an element, or an element promises more bytes than are left</source>
        <translation>filen slutter i et element, eller et element lover flere byte enn det er igjen</translation>
    </message>
    <message>
        <source>is not a DICOM file: neither &apos;DICM&apos; nor an element stands where it should</source>
        <translation>er ingen DICOM-fil: verken «DICM» eller et element står der det skulle</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind</source>
        <translation>Gi filen endelsen til sin type</translation>
    </message>
    <message>
        <source>is a single slice, which makes no volume</source>
        <translation>er et enkelt snitt, som ikke gir noe volum</translation>
    </message>
    <message>
        <source>its slices do not lie above each other on one grid</source>
        <translation>snittene ligger ikke over hverandre på ett rutenett</translation>
    </message>
    <message>
        <source>its slices are not evenly spaced; some moved by %1 mm</source>
        <translation>snittene ligger ikke like langt fra hverandre; noen ble flyttet %1 mm</translation>
    </message>
    <message>
        <source>Give all slices of the series, or have another program resample it evenly</source>
        <translation>Åpne alle snittene i serien, eller la et annet program gjøre den jevn</translation>
    </message>
    <message>
        <source>Give the slices of one series, of one orientation and size</source>
        <translation>Åpne snittene i én serie, med én retning og størrelse</translation>
    </message>
    <message>
        <source>none of its segments has a pixel</source>
        <translation>ingen av segmentene har en piksel</translation>
    </message>
    <message>
        <source>its contours enclose nothing; left out</source>
        <translation>konturene omslutter ingenting; utelatt</translation>
    </message>
    <message>
        <source>has no contour; left out</source>
        <translation>har ingen kontur; utelatt</translation>
    </message>
    <message>
        <source>holds points or open lines only; left out</source>
        <translation>inneholder bare punkter eller åpne linjer; utelatt</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>XML-en er ødelagt: %1</translation>
    </message>
    <message>
        <source>Save the scene again in 3D Slicer</source>
        <translation>Lagre scenen på nytt i 3D Slicer</translation>
    </message>
    <message>
        <source>it is XML, but no 3D Slicer scene: there is no &lt;MRML&gt;</source>
        <translation>er XML, men ingen scene fra 3D Slicer: det finnes ingen &lt;MRML&gt;</translation>
    </message>
    <message>
        <source>Choose the .mrml file that 3D Slicer saved</source>
        <translation>Velg .mrml-filen som 3D Slicer lagret</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>filen er tom</translation>
    </message>
    <message>
        <source>Save the fiducials again in 3D Slicer</source>
        <translation>Lagre merkene på nytt i 3D Slicer</translation>
    </message>
    <message>
        <source>the scene has no saved views to tour</source>
        <translation>scenen har ingen lagrede visninger å gå gjennom</translation>
    </message>
    <message>
        <source>the scene has one saved view alone: there is no way to go</source>
        <translation>scenen har bare én lagret visning: det er ingen vei å gå</translation>
    </message>
    <message>
        <source>rests of %1 seconds leave no time to move in a film of %2</source>
        <translation>hvil på %1 sekunder gir ingen tid til bevegelse i en film på %2</translation>
    </message>
    <message>
        <source>Make the rests shorter or the film longer</source>
        <translation>Gjør hvilene kortere eller filmen lengre</translation>
    </message>
    <message>
        <source>frames of %1 pixels are none for a film</source>
        <translation>bilder på %1 piksler er ikke noe for en film</translation>
    </message>
    <message>
        <source>Choose a size of which both sides have 16 to 4320 pixels</source>
        <translation>Velg en størrelse der begge sider har 16 til 4320 piksler</translation>
    </message>
    <message>
        <source>the ffmpeg that is installed has no encoder for MP4 films</source>
        <translation>den installerte ffmpeg har ingen koder for MP4-filmer</translation>
    </message>
    <message>
        <source>Install an ffmpeg with libx264, or write an animated WebP or GIF</source>
        <translation>Installer en ffmpeg med libx264, eller skriv en animert WebP eller GIF</translation>
    </message>
    <message>
        <source>the film cannot be made: %1</source>
        <translation>filmen kan ikke lages: %1</translation>
    </message>
    <message>
        <source>Make it smaller, or of another kind</source>
        <translation>Gjør den mindre, eller av en annen type</translation>
    </message>
    <message>
        <source>the part of the program for pictures of this kind cannot be loaded: %1</source>
        <translation>den delen av programmet som er for bilder av denne typen, kan ikke lastes: %1</translation>
    </message>
    <message>
        <source>modelling was cancelled</source>
        <translation>modelleringen ble avbrutt</translation>
    </message>
    <message>
        <source>the graphics driver gives no OpenGL context to draw with</source>
        <translation>grafikkdriveren gir ingen OpenGL-kontekst å tegne med</translation>
    </message>
    <message>
        <source>Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>Oppdater grafikkdriveren, eller sett LIBGL_ALWAYS_SOFTWARE=1</translation>
    </message>
    <message>
        <source>does not begin like a NIfTI file</source>
        <translation>begynner ikke som en NIfTI-fil</translation>
    </message>
    <message>
        <source>Export it as NIfTI again, or give the file the extension of its kind</source>
        <translation>Eksporter den på nytt som NIfTI, eller gi filen endelsen til sin type</translation>
    </message>
    <message>
        <source>%1 of %2 left/right names contradict the frame %3 that the files give; %4</source>
        <translation>%1 av %2 sidenavn motsier rammen %3 som filene oppgir; %4</translation>
    </message>
    <message>
        <source>front and back are right: if the files are mirrored, choose %1</source>
        <translation>foran og bak stemmer: er filene speilvendt, velg %1</translation>
    </message>
    <message>
        <source>front and back are swapped too: choose %1</source>
        <translation>foran og bak er også byttet om: velg %1</translation>
    </message>
    <message>
        <source>if left and right are swapped, choose %1 where front and back are swapped too, else %2</source>
        <translation>er venstre og høyre byttet om, velg %1 der også foran og bak er byttet om, ellers %2</translation>
    </message>
    <message>
        <source>Give the file one of these endings</source>
        <translation>Gi filen en av disse endelsene</translation>
    </message>
    <message>
        <source>the sheet would have more than 20000 pixels on a side</source>
        <translation>arket ville ha mer enn 20000 piksler på en side</translation>
    </message>
    <message>
        <source>its atoms lie too far apart for a lattice between them</source>
        <translation>atomene ligger for langt fra hverandre til et gitter mellom dem</translation>
    </message>
    <message>
        <source>it has more than %1 atoms</source>
        <translation>det har mer enn %1 atomer</translation>
    </message>
    <message>
        <source>Find the pockets of fewer chains at a time</source>
        <translation>Finn lommene til færre kjeder om gangen</translation>
    </message>
    <message>
        <source>its atoms lie closer together than those of matter do</source>
        <translation>atomene ligger tettere enn de i materie gjør</translation>
    </message>
    <message>
        <source>Repair the file</source>
        <translation>Reparer filen</translation>
    </message>
    <message>
        <source>the large probe must be larger than the small one</source>
        <translation>den store kulen må være større enn den lille</translation>
    </message>
    <message>
        <source>panel %1</source>
        <translation>felt %1</translation>
    </message>
    <message>
        <source>panel %1, an inset of %2</source>
        <translation>felt %1, et utsnitt av %2</translation>
    </message>
    <message>
        <source>letters and legend</source>
        <translation>bokstaver og tegnforklaring</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is set in %2 pt, and letters smaller than %3 pt are refused</source>
        <translation>«%1» står i %2 pt, og bokstaver under %3 pt avvises</translation>
    </message>
    <message>
        <source>Make &quot;points&quot; %1 or more, or &quot;least_points&quot; %2</source>
        <translation>Sett «points» til %1 eller mer, eller «least_points» til %2</translation>
    </message>
    <message>
        <source>it reaches over the page&apos;s edge or into the legend</source>
        <translation>det går over kanten av siden eller inn i tegnforklaringen</translation>
    </message>
    <message>
        <source>Move it, make it smaller or the page larger</source>
        <translation>Flytt det, gjør det mindre eller siden større</translation>
    </message>
    <message>
        <source>it is narrower or lower than 10 mm</source>
        <translation>det er smalere eller lavere enn 10 mm</translation>
    </message>
    <message>
        <source>Make the page larger, or take fewer columns or rows</source>
        <translation>Gjør siden større, eller ta færre kolonner eller rader</translation>
    </message>
    <message>
        <source>the part that it shows reaches over the edge of panel %1</source>
        <translation>delen som det viser, går over kanten av felt %1</translation>
    </message>
    <message>
        <source>Move the part, or make it smaller</source>
        <translation>Flytt delen, eller gjør den mindre</translation>
    </message>
    <message>
        <source>it spans more columns than there are</source>
        <translation>det spenner over flere kolonner enn det finnes</translation>
    </message>
    <message>
        <source>Give the grid more columns</source>
        <translation>Gi rutenettet flere kolonner</translation>
    </message>
    <message>
        <source>a legend tells colours, and ink alone has none</source>
        <translation>en tegnforklaring forklarer farger, og blekk alene har ingen</translation>
    </message>
    <message>
        <source>it does not lie in the figure&apos;s folder or below it</source>
        <translation>den ligger ikke i figurens mappe eller under den</translation>
    </message>
    <message>
        <source>Put the figure&apos;s file beside its scenes</source>
        <translation>Legg figurens fil ved siden av scenene</translation>
    </message>
    <message>
        <source>the scene has never been saved</source>
        <translation>scenen er aldri lagret</translation>
    </message>
    <message>
        <source>Save it first, so that the figure&apos;s file can name it</source>
        <translation>Lagre den først, så figurens fil kan nevne den</translation>
    </message>
    <message>
        <source>Leave one of both out</source>
        <translation>Utelat en av dem</translation>
    </message>
    <message>
        <source>Take fewer pixels to the inch, or a smaller sheet</source>
        <translation>Ta færre piksler per tomme eller et mindre ark</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>det finnes ingen mappe %1</translation>
    </message>
    <message>
        <source>names say that z does not lead to the head: turn the files</source>
        <translation>navn sier at z ikke fører til hodet: vri filene</translation>
    </message>
    <message>
        <source>names of front and back contradict the frame %1; if the files are mirrored, choose %2</source>
        <translation>navn med foran og bak motsier koordinatsystemet %1; velg %2 hvis filene er speilvendt</translation>
    </message>
    <message>
        <source>surfaces whose files do not say their frame lie beside the others, whether they are read as LPS or as RAS; %1 was assumed</source>
        <translation>flater der filene ikke oppgir koordinatsystemet, ligger ved siden av de andre, enten de leses som LPS eller RAS; %1 ble antatt</translation>
    </message>
    <message>
        <source>scenes of 3D Slicer beside it disagree about its coordinates; none of them was followed</source>
        <translation>scener fra 3D Slicer ved siden av er uenige om koordinatene; ingen av dem ble fulgt</translation>
    </message>
    <message>
        <source>%1 of %2 structures are not as large as their names say: &quot;%3&quot; is %4 mm large, and such structures are %5 to %6 mm; %7</source>
        <translation>%1 av %2 strukturer er ikke så store som navnene sier: «%3» er %4 mm stor, og slike strukturer er %5 til %6 mm; %7</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 mm large, and such structures are %3 to %4 mm; %5</source>
        <translation>«%1» er %2 mm stor, og slike strukturer er %3 til %4 mm; %5</translation>
    </message>
    <message>
        <source>no usual unit would make it right</source>
        <translation>ingen vanlig enhet ville gjøre det riktig</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 mm</source>
        <translation>det ville stemme hvis filens enhet var %1 mm</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 or %2 mm</source>
        <translation>det ville stemme hvis filens enhet var %1 eller %2 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is flat: it has no extent in a direction</source>
        <translation>«%1» er flat: den har ingen utstrekning i én retning</translation>
    </message>
    <message>
        <source>&quot;%1&quot; beside it gives none of its labels a name that is understood</source>
        <translation>«%1» ved siden av gir ingen av etikettene et navn som forstås</translation>
    </message>
    <message>
        <source>holds %1 label volumes of one place, as points in time; structures of all of them lie over each other</source>
        <translation>inneholder %1 etikettvolumer av ett sted, som tidspunkter; strukturene i alle ligger oppå hverandre</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units; the sform was taken</source>
        <translation>sform og qform plasserer det forskjellig, opptil %1 av dets enheter fra hverandre; sform ble brukt</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units and with left and right swapped; the sform was taken</source>
        <translation>sform og qform plasserer det forskjellig, opptil %1 av dets enheter fra hverandre og med venstre og høyre byttet om; sform ble brukt</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as the file says</source>
        <translation>er tegnet på ett snitt; gjort %1 mm tykk, som filen sier</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as slices of other structures are</source>
        <translation>er tegnet på ett snitt; gjort %1 mm tykk, som snittene til andre strukturer</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, which nothing tells</source>
        <translation>er tegnet på ett snitt; gjort %1 mm tykk, noe ingenting sier</translation>
    </message>
    <message>
        <source>is of another patient than the files before it; left out</source>
        <translation>er av en annen pasient enn filene før den; utelatt</translation>
    </message>
    <message>
        <source>files of one patient lie in different frames of reference: nothing says that what is laid over each other fits</source>
        <translation>filer av én pasient ligger i ulike referansesystemer: ingenting sier at det som ligger oppå hverandre, passer</translation>
    </message>
    <message>
        <source>it is of another patient than the other files now</source>
        <translation>den er nå av en annen pasient enn de andre filene</translation>
    </message>
    <message>
        <source>it lies more than 100 km from the origin</source>
        <translation>det ligger mer enn 100 km fra origo</translation>
    </message>
    <message>
        <source>Check the unit of its coordinates</source>
        <translation>Kontroller enheten til koordinatene</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across: an implausible size, check the unit</source>
        <translation>«%1» måler %2: en usannsynlig størrelse, kontroller enheten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 other is as unlikely: an implausible size, check the unit</source>
        <translation>«%1» måler %2, og %3 annen er like usannsynlig: kontroller enheten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 others are as unlikely: an implausible size, check the unit</source>
        <translation>«%1» måler %2, og %3 andre er like usannsynlige: kontroller enheten</translation>
    </message>
    <message>
        <source>eye or target lies more than 100,000 km away</source>
        <translation>øye eller mål ligger mer enn 100 000 km unna</translation>
    </message>
    <message>
        <source>the height is too small or too large for where eye and target lie</source>
        <translation>høyden er for liten eller for stor for hvor øye og mål ligger</translation>
    </message>
    <message>
        <source>weak vote: %1 of %2 left/right names</source>
        <translation>svak avstemning: %1 av %2 navn med venstre/høyre</translation>
    </message>
    <message>
        <source>names of front and back alone</source>
        <translation>bare navn med foran og bak</translation>
    </message>
    <message>
        <source>laid over surfaces of the same names: %1 within 2 mm</source>
        <translation>lagt over flater med samme navn: %1 innenfor 2 mm</translation>
    </message>
    <message>
        <source>fits in with the other surfaces</source>
        <translation>passer med de andre flatene</translation>
    </message>
    <message>
        <source>confirmed by hand</source>
        <translation>bekreftet for hånd</translation>
    </message>
    <message>
        <source>mirrored by hand</source>
        <translation>speilvendt for hånd</translation>
    </message>
    <message>
        <source>turned by hand</source>
        <translation>dreid for hånd</translation>
    </message>
    <message>
        <source>%1; sizes are not those of what is named</source>
        <translation>%1; størrelsene er ikke dem det navngitte har</translation>
    </message>
    <message>
        <source>the program held %1 bytes for %2×%3 pixels of the picture, which is not what they take</source>
        <translation>programmet hadde %1 byte for %2×%3 piksler av bildet, og det er ikke det de trenger</translation>
    </message>
    <message>
        <source>Save the scene and start the program again</source>
        <translation>Lagre scenen og start programmet på nytt</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;: %2</source>
        <translation>Struktur «%1»: %2</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;: %2</source>
        <translation>Gruppe «%1»: %2</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;: %2</source>
        <translation>Visning «%1»: %2</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;: %2</source>
        <translation>Etikett «%1»: %2</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;: %2</source>
        <translation>Skann «%1»: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;</source>
        <translation>Struktur «%1»</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;</source>
        <translation>Gruppe «%1»</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;</source>
        <translation>Visning «%1»</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;</source>
        <translation>Etikett «%1»</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;</source>
        <translation>Skann «%1»</translation>
    </message>
    <message>
        <source>%1; it was cut there</source>
        <translation>%1; det ble kuttet der</translation>
    </message>
    <message>
        <source>%1; it was left out</source>
        <translation>%1; det ble utelatt</translation>
    </message>
    <message>
        <source>%1; they became signs for unknown letters</source>
        <translation>%1; de ble til tegn for ukjente bokstaver</translation>
    </message>
    <message>
        <source>%1; the rest was left out</source>
        <translation>%1; resten ble utelatt</translation>
    </message>
    <message>
        <source>%1; the section was left out</source>
        <translation>%1; snittet ble utelatt</translation>
    </message>
    <message>
        <source>%1; the atoms were left out</source>
        <translation>%1; atomene ble utelatt</translation>
    </message>
    <message>
        <source>%1; what is in it went to the group above</source>
        <translation>%1; det som er i den, gikk til gruppen over</translation>
    </message>
    <message>
        <source>the name is longer than %1 bytes</source>
        <translation>navnet er lengre enn %1 byte</translation>
    </message>
    <message>
        <source>the text is longer than %1 bytes</source>
        <translation>teksten er lengre enn %1 byte</translation>
    </message>
    <message>
        <source>a text is longer than %1 bytes</source>
        <translation>en tekst er lengre enn %1 byte</translation>
    </message>
    <message>
        <source>its credit is longer than %1 bytes</source>
        <translation>kildeangivelsen er lengre enn %1 byte</translation>
    </message>
    <message>
        <source>%1 is longer than %2 bytes</source>
        <translation>%1 er lengre enn %2 byte</translation>
    </message>
    <message>
        <source>the name has bytes that are no letters in UTF-8</source>
        <translation>navnet har byte som ikke er tegn i UTF-8</translation>
    </message>
    <message>
        <source>%1 has bytes that are no letters in UTF-8</source>
        <translation>%1 har byte som ikke er tegn i UTF-8</translation>
    </message>
    <message>
        <source>%1 is in more than %2 languages</source>
        <translation>%1 finnes på mer enn %2 språk</translation>
    </message>
    <message>
        <source>%1 is in a language that has no name</source>
        <translation>%1 er på et språk uten navn</translation>
    </message>
    <message>
        <source>%1 is no finite number</source>
        <translation>%1 er ikke et endelig tall</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>verdien av %1 er utenfor grensene</translation>
    </message>
    <message>
        <source>the time is out of range</source>
        <translation>tiden er utenfor grensene</translation>
    </message>
    <message>
        <source>it lies more than %1 groups deep</source>
        <translation>den ligger mer enn %1 grupper dypt</translation>
    </message>
    <message>
        <source>it is on a triangle that no structure of the scene has</source>
        <translation>det peker på en trekant som ingen struktur i scenen har</translation>
    </message>
    <message>
        <source>what is painted on it is of another surface</source>
        <translation>det som er malt på den, hører til en annen overflate</translation>
    </message>
    <message>
        <source>an atom lies nowhere, or there are too many</source>
        <translation>et atom ligger ingen steder, eller det er for mange</translation>
    </message>
    <message>
        <source>a scene holds no more than %1 %2, and these would be %3</source>
        <translation>en scene rommer høyst %1 %2, og dette ville være %3</translation>
    </message>
    <message>
        <source>structures and groups</source>
        <translation>strukturer og grupper</translation>
    </message>
    <message>
        <source>Take fewer of them into one scene</source>
        <translation>Ta færre av dem inn i én scene</translation>
    </message>
    <message>
        <source>Change it so that a scene file can keep it</source>
        <translation>Endre det slik at en scenefil kan ta vare på det</translation>
    </message>
    <message>
        <source>Undo what brought it into the scene, and save again</source>
        <translation>Angre det som brakte det inn i scenen, og lagre på nytt</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file</source>
        <translation>scenen er for stor for en scenefil</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file: %1</source>
        <translation>scenen er for stor for en scenefil: %1</translation>
    </message>
    <message>
        <source>Save fewer views, or fewer structures in one scene</source>
        <translation>Lagre færre visninger eller færre strukturer i én scene</translation>
    </message>
    <message>
        <source>Put fewer structures or scans into one scene</source>
        <translation>Legg færre strukturer eller skann i én scene</translation>
    </message>
    <message>
        <source>something in it is at fault and not in the scene; it would be lost</source>
        <translation>noe i den er feil og ikke i scenen; det ville gå tapt</translation>
    </message>
    <message>
        <source>something in it is at fault: %1</source>
        <translation>noe i den er feil: %1</translation>
    </message>
    <message>
        <source>Open it by itself and save it under another name</source>
        <translation>Åpne den for seg og lagre den under et annet navn</translation>
    </message>
    <message>
        <source>something in it is at fault and was left out (%1); the file stays as it is, and the scene can only be saved under another name</source>
        <translation>noe i den er feil og ble utelatt (%1); filen blir som den er, og scenen kan bare lagres under et annet navn</translation>
    </message>
    <message>
        <source>a newer version of the program has written it (schema %1, known here: %2); what is unknown is not shown, and it can only be saved under another name, as schema %3</source>
        <translation>en nyere versjon av programmet har skrevet den (skjema %1, kjent her: %2); det ukjente vises ikke, og den kan bare lagres under et annet navn, som skjema %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; (%2): %3</source>
        <translation>«%1» (%2): %3</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected here</source>
        <translation>her ventes et tall fra %1 til %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected here</source>
        <translation>her ventes et helt tall fra %1 til %2</translation>
    </message>
    <message>
        <source>a text is expected here</source>
        <translation>her ventes en tekst</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>her ventes et tall</translation>
    </message>
    <message>
        <source>true or false is expected here</source>
        <translation>her ventes true eller false</translation>
    </message>
    <message>
        <source>a list is expected here</source>
        <translation>her ventes en liste</translation>
    </message>
    <message>
        <source>an object is expected here</source>
        <translation>her ventes et objekt</translation>
    </message>
    <message>
        <source>a line of at most %1 bytes is expected here</source>
        <translation>her ventes en linje på høyst %1 byte</translation>
    </message>
    <message>
        <source>a colour as &quot;#rrggbb&quot; is expected here</source>
        <translation>her ventes en farge som «#rrggbb»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or another word of this format is expected here</source>
        <translation>her ventes «%1» eller et annet ord i dette formatet</translation>
    </message>
    <message>
        <source>the file holds no such mesh</source>
        <translation>filen inneholder ikke noe slikt nett</translation>
    </message>
    <message>
        <source>it is no mesh of this format</source>
        <translation>det er ikke noe nett i dette formatet</translation>
    </message>
    <message>
        <source>%1; the structure stays as an empty row</source>
        <translation>%1; strukturen blir stående som en tom rad</translation>
    </message>
    <message>
        <source>the file holds no such paint</source>
        <translation>filen inneholder ingen slik maling</translation>
    </message>
    <message>
        <source>it does not begin like what is painted on a mesh</source>
        <translation>det begynner ikke som det som er malt på et nett</translation>
    </message>
    <message>
        <source>it does not begin like the voxels of a scan</source>
        <translation>det begynner ikke som voxlene i en skanning</translation>
    </message>
    <message>
        <source>its unit is stated (%1) and was followed</source>
        <translation>enheten er oppgitt (%1) og ble fulgt</translation>
    </message>
    <message>
        <source>%1 lies on the other side than its name says</source>
        <translation>%1 ligger på den andre siden enn navnet sier</translation>
    </message>
    <message>
        <source>%1 lie on the other side than their names say</source>
        <translation>%1 ligger på den andre siden enn navnene sier</translation>
    </message>
    <message>
        <source>molecules are drawn with 1 Å as 1 mm, ten million times as large as &quot;%1&quot; beside them; no scale bar holds for both, so open them apart</source>
        <translation>molekyler er tegnet med 1 Å som 1 mm, ti millioner ganger så store som «%1» ved siden av; ingen målestokk gjelder for begge, så åpne dem hver for seg</translation>
    </message>
    <message>
        <source>SlicerRT&apos;s segmentations are RAS</source>
        <translation>segmenteringer fra SlicerRT er RAS</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, which are not as many as it has; it was placed as if its origin were its own</source>
        <translation>sier at den inneholder vokslene %1 av et referansebilde, og det er ikke så mange som den har; den ble plassert som om origo var dens eget</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, and an offset in it, as files with an origin of their own do; it was placed by its origin alone</source>
        <translation>nevner vokslene %1 av et referansebilde og en forskyvning i det, slik filer med eget origo gjør; den ble plassert etter sitt origo alene</translation>
    </message>
    <message>
        <source>the files are of %1 patients: %2</source>
        <translation>filene er av %1 pasienter: %2</translation>
    </message>
    <message>
        <source>the files are of %1 studies, and nothing says that they are of one patient: %2</source>
        <translation>filene er av %1 undersøkelser, og ingenting sier at de er av én pasient: %2</translation>
    </message>
    <message>
        <source>Give the files of one patient, or put them together on purpose</source>
        <translation>Gi filene til én pasient, eller sett dem sammen med hensikt</translation>
    </message>
    <message>
        <source>it came from more than %1 studies</source>
        <translation>den kom fra mer enn %1 undersøkelser</translation>
    </message>
    <message>
        <source>what was there already is read as %1 now: %2</source>
        <translation>det som allerede var der, leses nå som %1: %2</translation>
    </message>
    <message>
        <source>left and right of what was there already are certain now: %1</source>
        <translation>venstre og høyre i det som allerede var der, er nå sikre: %1</translation>
    </message>
    <message>
        <source>is a scan rather than a label volume: %1</source>
        <translation>er en skanning og ikke et etikettvolum: %1</translation>
    </message>
    <message>
        <source>Give a threshold that makes a structure of it, or choose the segmentation that was made of it</source>
        <translation>Gi en terskel som lager en struktur av den, eller velg segmenteringen som ble laget av den</translation>
    </message>
    <message>
        <source>Structures come from a DICOM segmentation or RT structure set, from label maps and meshes made of the images, or from a threshold</source>
        <translation>Strukturer kommer fra en DICOM-segmentering eller et RT-struktursett, fra etikettkart og nett laget av bildene, eller fra en terskel</translation>
    </message>
    <message>
        <source>Name one of the scene&apos;s saved views</source>
        <translation>Nevn en av scenens lagrede visninger</translation>
    </message>
    <message>
        <source>Change it in the figure&apos;s file</source>
        <translation>Endre det i figurens fil</translation>
    </message>
    <message>
        <source>a comparison sheet is a pdf, svg, png or tiff file</source>
        <translation>et sammenligningsark er en pdf-, svg-, png- eller tiff-fil</translation>
    </message>
    <message>
        <source>a figure is a pdf, svg, png or tiff file</source>
        <translation>en figur er en pdf-, svg-, png- eller tiff-fil</translation>
    </message>
    <message>
        <source>a depth of 1 bit leaves black and white alone, and the figure has tones</source>
        <translation>en dybde på 1 bit gir bare svart og hvitt, og figuren har toner</translation>
    </message>
    <message>
        <source>Let the figure be black and white, or take 8 bits</source>
        <translation>La figuren være svart-hvit, eller velg 8 bit</translation>
    </message>
    <message>
        <source>names of sides in this folder contradict the frame of the others, %1; it was taken, and is not certain here</source>
        <translation>navn på sider i denne mappen motsier koordinatsystemet til de andre, %1; det ble brukt og er ikke sikkert her</translation>
    </message>
    <message>
        <source>the files of this folder are read as %1, unlike others: %2</source>
        <translation>filene i denne mappen leses annerledes enn andre, som %1: %2</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image; its origin was taken to be that image&apos;s</source>
        <translation>sier at den inneholder vokslene %1 av et referansebilde; origo ble tatt som bildets</translation>
    </message>
    <message>
        <source>Save it as a scene file, and name it with its ending .sline</source>
        <translation>Lagre det som en scenefil, og gi den endelsen .sline</translation>
    </message>
    <message>
        <source>words and numbers of no anatomy, maybe a person&apos;s, left out of names: %1</source>
        <translation>i navn utelatte ord og tall som ikke hører til anatomien, men kan høre til en person; antall navn: %1</translation>
    </message>
    <message>
        <source>there is no such member in the file</source>
        <translation>filen inneholder ingen slik del</translation>
    </message>
    <message>
        <source>the graphics driver has lost what it had drawn</source>
        <translation>grafikkdriveren har mistet det den hadde tegnet</translation>
    </message>
    <message>
        <source>the graphics driver has no memory left for the picture</source>
        <translation>grafikkdriveren har ikke mer minne til bildet</translation>
    </message>
    <message>
        <source>the names of the files tell of %1 bodies: %2</source>
        <translation>navnene på filene forteller om %1 kropper: %2</translation>
    </message>
    <message>
        <source>another file of this name is not as it was read; name its folder if that one is meant</source>
        <translation>en annen fil med dette navnet er ikke som den ble lest; nevn mappen dens hvis det er den som menes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 large now and was %3: its file may have another unit</source>
        <translation>«%1» er nå %2 stor og var %3: filen kan ha en annen enhet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies %2 away from where it was: it may be another body&apos;s, or mirrored</source>
        <translation>«%1» ligger %2 fra der den var: den kan være fra en annen kropp eller speilvendt</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations.</source>
        <translation>Gjør segmentert anatomi til strekillustrasjoner med fokus og kontekst.</translation>
    </message>
    <message>
        <source>Meshes, label volumes, DICOM segmentations, molecules, folders of them, 3D Slicer scenes, scene files.</source>
        <translation>Nett, etikettvolumer, DICOM-segmenteringer, molekyler, mapper med slike, 3D Slicer-scener, scenefiler.</translation>
    </message>
    <message>
        <source>Opens a scene that the program models itself: %1.</source>
        <translation>Åpner en scene som programmet selv modellerer: %1.</translation>
    </message>
    <message>
        <source>Opens a window of its own, whatever the preferences say of files from outside.</source>
        <translation>Åpner et eget vindu, uansett hva innstillingene sier om filer utenfra.</translation>
    </message>
</context>
<context>
    <name>sline::render::ExportFormat</name>
    <message>
        <source>Vectors for Inkscape, Illustrator and print: lines and hatching as smooth paths, hidden ones removed, a named group for each structure</source>
        <translation>Vektorer for Inkscape, Illustrator og trykk: linjer og skravur som glatte baner, skjulte fjernet, en navngitt gruppe for hver struktur</translation>
    </message>
    <message>
        <source>A picture made of pixels for screens, documents and print: sRGB, grey or pure ink, 8 or 16 bits, transparent where asked for</source>
        <translation>Et bilde av piksler for skjerm, dokumenter og trykk: sRGB, grått eller rent blekk, 8 eller 16 biter, gjennomsiktig om ønsket</translation>
    </message>
    <message>
        <source>The same for printers and journals, with its colour profile</source>
        <translation>Det samme for trykkerier og tidsskrifter, med fargeprofil</translation>
    </message>
    <message>
        <source>A picture made of pixels where files must be small; on white</source>
        <translation>Et bilde av piksler der filer må være små; på hvitt</translation>
    </message>
    <message>
        <source>A picture in linear light, as halves with alpha multiplied in, for compositing</source>
        <translation>Et bilde i lineært lys, halv presisjon, med alfa ganget inn, til sammensetting</translation>
    </message>
    <message>
        <source>Surfaces for Blender, PowerPoint, web pages and headsets: groups, names and colours, annotations, cameras of the saved views</source>
        <translation>Overflater for Blender, PowerPoint, nettsider og briller: grupper, navn og farger, etiketter, kameraene til lagrede visninger</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4-film</translation>
    </message>
    <message>
        <source>A film for slides and web pages, where the program ffmpeg is installed</source>
        <translation>En film til lysbilder og nettsider, der programmet ffmpeg er installert</translation>
    </message>
    <message>
        <source>Animated WebP</source>
        <translation>Animert WebP</translation>
    </message>
    <message>
        <source>A film that browsers show as a picture</source>
        <translation>En film som nettlesere viser som bilde</translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation>Animert GIF</translation>
    </message>
    <message>
        <source>A film that every program shows, of at most 255 colours: small ones</source>
        <translation>En film som alle programmer viser, med høyst 255 farger: for små</translation>
    </message>
    <message>
        <source>Frames of a film</source>
        <translation>Enkeltbilder av en film</translation>
    </message>
    <message>
        <source>A new folder of numbered PNG pictures, for programs that cut films</source>
        <translation>En ny mappe med nummererte PNG-bilder, for redigeringsprogrammer</translation>
    </message>
    <message>
        <source>Anki deck</source>
        <translation>Anki-kortstokk</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-bilde</translation>
    </message>
    <message>
        <source>TIFF picture</source>
        <translation>TIFF-bilde</translation>
    </message>
    <message>
        <source>JPEG picture</source>
        <translation>JPEG-bilde</translation>
    </message>
    <message>
        <source>EXR picture</source>
        <translation>EXR-bilde</translation>
    </message>
    <message>
        <source>WebP picture</source>
        <translation>WebP-bilde</translation>
    </message>
    <message>
        <source>A picture for web pages, smaller than PNG and as exact: 8 bits in colour</source>
        <translation>Et bilde for nettsider, mindre enn PNG og like nøyaktig: 8 biter i farger</translation>
    </message>
    <message>
        <source>JPEG 2000 picture</source>
        <translation>JPEG 2000-bilde</translation>
    </message>
    <message>
        <source>A picture for archives that ask for it, exact: 8 or 16 bits</source>
        <translation>Et bilde for arkiver som ber om det, nøyaktig: 8 eller 16 biter</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-tegning</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-dokument</translation>
    </message>
    <message>
        <source>GLB surfaces (glTF)</source>
        <translation>GLB-overflater (glTF)</translation>
    </message>
    <message>
        <source>PowerPoint slides</source>
        <translation>PowerPoint-lysbilder</translation>
    </message>
    <message>
        <source>A slide for each saved view with its title, text and notes: labels are text boxes and lines that can be edited there, over the drawing</source>
        <translation>Et lysbilde for hver lagrede visning med tittel, tekst og notater: etiketter er tekstbokser og linjer over tegningen, som kan redigeres der</translation>
    </message>
    <message>
        <source>The same vectors on a page of their own, or a sheet with title, legend and numbered labels, a page to test oneself and its key; of all saved views with contents and an index</source>
        <translation>De samme vektorene på en egen side, eller et ark med tittel, tegnforklaring og nummererte betegnelser, en side til egentest og fasiten; av alle lagrede visninger med innhold og register</translation>
    </message>
    <message>
        <source>Cards that ask for the labels of the picture, or of all saved views: a package for Anki (.apkg), or text and pictures in a ZIP (.zip) or a new folder</source>
        <translation>Kort som spør etter betegnelsene i bildet eller i alle lagrede visninger: en pakke for Anki (.apkg), eller tekst og bilder i en ZIP (.zip) eller en ny mappe</translation>
    </message>
    <message>
        <source>For students (HTML page)</source>
        <translation>For studenter (HTML-side)</translation>
    </message>
    <message>
        <source>One file for any browser, also offline and on telephones: the scene to turn, with its tree, labels, saved views as a tour, and a quiz</source>
        <translation>Én fil for alle nettlesere, også uten nett og på telefoner: scenen til å dreie, med tre, etiketter, lagrede visninger som omvisning og en quiz</translation>
    </message>
    <message>
        <source>For students (web site)</source>
        <translation>For studenter (nettsted)</translation>
    </message>
    <message>
        <source>The same page as a new folder of files for a web server, most of which are the same for every scene; browsers do not open it from a disk</source>
        <translation>Den samme siden som en ny mappe med filer for en nettjener, der de fleste er like for alle scener; nettlesere åpner den ikke fra disken</translation>
    </message>
    <message>
        <source>Moodle questions</source>
        <translation>Moodle-spørsmål</translation>
    </message>
    <message>
        <source>Questions with pictures, made of the labels, as XML for a question bank: markers to be put in place, names to be typed or chosen</source>
        <translation>Spørsmål med bilder, laget av etikettene, som XML til en spørsmålsbank: merker som skal på plass, navn som skrives eller velges</translation>
    </message>
    <message>
        <source>QTI questions</source>
        <translation>QTI-spørsmål</translation>
    </message>
    <message>
        <source>The same for other question banks and examination systems, as a package of QTI 2.1</source>
        <translation>Det samme for andre spørsmålsbanker og eksamenssystemer, som pakke av QTI 2.1</translation>
    </message>
    <message>
        <source>H5P questions</source>
        <translation>H5P-spørsmål</translation>
    </message>
    <message>
        <source>The same as content for H5P, to be played where its content types are installed</source>
        <translation>Det samme som innhold for H5P, som spilles der innholdstypene er installert</translation>
    </message>
    <message>
        <source>SCORM 1.2 package</source>
        <translation>SCORM 1.2-pakke</translation>
    </message>
    <message>
        <source>The page for students in a package that tells a learning system each answer and the score, by the standard that most systems know</source>
        <translation>Siden for studenter i en pakke som melder hvert svar og resultatet til et læringssystem, etter standarden som de fleste kjenner</translation>
    </message>
    <message>
        <source>SCORM 2004 package</source>
        <translation>SCORM 2004-pakke</translation>
    </message>
    <message>
        <source>The same by SCORM 2004, 4th edition</source>
        <translation>Det samme etter SCORM 2004, 4. utgave</translation>
    </message>
    <message>
        <source>cmi5 package</source>
        <translation>cmi5-pakke</translation>
    </message>
    <message>
        <source>The same by cmi5, for systems with a learning record store</source>
        <translation>Det samme etter cmi5, for systemer med et læringslager (LRS)</translation>
    </message>
</context>
<context>
    <name>sline::render::ExportOption</name>
    <message>
        <source>&amp;Deck</source>
        <translation>&amp;Kortstokk</translation>
    </message>
    <message>
        <source>Its name in Anki; else the view&apos;s name</source>
        <translation>Navnet i Anki; ellers visningens navn</translation>
    </message>
    <message>
        <source>Once around</source>
        <translation>Én gang rundt</translation>
    </message>
    <message>
        <source>From view to view</source>
        <translation>Fra visning til visning</translation>
    </message>
    <message>
        <source>Γ from 0 to 5</source>
        <translation>Γ fra 0 til 5</translation>
    </message>
    <message>
        <source>Len&amp;gth</source>
        <translation>Va&amp;righet</translation>
    </message>
    <message>
        <source>Of the whole film</source>
        <translation>For hele filmen</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Pictures a secon&amp;d</source>
        <translation>Bil&amp;der i sekundet</translation>
    </message>
    <message>
        <source>More are smoother, and more to draw</source>
        <translation>Flere er jevnere, og mer å tegne</translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation>Filmens høyde</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>Be&amp;vegelse</translation>
    </message>
    <message>
        <source>What moves in the film</source>
        <translation>Det som beveger seg i filmen</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Hvit</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papir</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørk</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Gjennomsiktig</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numre</translation>
    </message>
    <message>
        <source>Blank lines, for a test</source>
        <translation>Tomme linjer, til en prøve</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Etiketter</translation>
    </message>
    <message>
        <source>How the scene&apos;s labels stand in the picture</source>
        <translation>Hvordan scenens etiketter står i bildet</translation>
    </message>
    <message>
        <source>Le&amp;tters</source>
        <translation>&amp;Bokstaver</translation>
    </message>
    <message>
        <source>How large the letters of labels are on paper</source>
        <translation>Hvor store bokstavene i etikettene er på papir</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message>
        <source>&amp;Right and left</source>
        <translation>&amp;Høyre og venstre</translation>
    </message>
    <message>
        <source>R and L, and the body&apos;s other directions</source>
        <translation>R og L og kroppens andre retninger</translation>
    </message>
    <message>
        <source>&amp;Name of the view</source>
        <translation>&amp;Navn på visningen</translation>
    </message>
    <message>
        <source>“Anterior view”, or the saved view&apos;s name</source>
        <translation>«Sett forfra» eller navnet på den lagrede visningen</translation>
    </message>
    <message>
        <source>S&amp;cale bar</source>
        <translation>&amp;Målestokk</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Hvor lang en centimeter er</translation>
    </message>
    <message>
        <source>S&amp;ections</source>
        <translation>&amp;Snitt</translation>
    </message>
    <message>
        <source>What sections have taken away</source>
        <translation>Hva snitt har tatt bort</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Opphav</translation>
    </message>
    <message>
        <source>Written into the file, which says of nobody who made it where this is empty</source>
        <translation>Skrives inn i filen; er det tomt, sier den ikke hvem som har laget den</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Rettigheter</translation>
    </message>
    <message>
        <source>Whose it is or what others may do with it, as in “CC BY 4.0”</source>
        <translation>Hvem som eier det, eller hva andre kan gjøre med det, som «CC BY 4.0»</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>Bak&amp;grunn</translation>
    </message>
    <message>
        <source>What lies behind the drawing</source>
        <translation>Hva som ligger bak tegningen</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Språk</translation>
    </message>
    <message>
        <source>Of texts and numbers; where a label has no text in it, the scene&apos;s own</source>
        <translation>For tekster og tall; der en etikett ikke har tekst på det, scenens eget</translation>
    </message>
    <message>
        <source>Black in&amp;k alone</source>
        <translation>Bare s&amp;vart blekk</translation>
    </message>
    <message>
        <source>For print without tones: each pixel is ink or paper; what is shaded is hatched instead</source>
        <translation>For trykk uten toner: hver piksel er blekk eller papir; det skyggelagte skraveres</translation>
    </message>
    <message>
        <source>The figure alone</source>
        <translation>Figuren alene</translation>
    </message>
    <message>
        <source>With title and legend</source>
        <translation>Med tittel og tegnforklaring</translation>
    </message>
    <message>
        <source>For teaching, with self-test</source>
        <translation>Til undervisning, med egentest</translation>
    </message>
    <message>
        <source>For a patient</source>
        <translation>For en pasient</translation>
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
        <translation>Arkets papir</translation>
    </message>
    <message>
        <source>Of sheets alone</source>
        <translation>Bare for ark</translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation>T&amp;ittel</translation>
    </message>
    <message>
        <source>At the head of a sheet</source>
        <translation>Øverst på et ark</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Of a sheet for a patient; each line is a paragraph</source>
        <translation>På et ark for en pasient; hver linje er et avsnitt</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Liggende</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>Bredere enn høyt</translation>
    </message>
    <message>
        <source>Shee&amp;t</source>
        <translation>&amp;Ark</translation>
    </message>
    <message>
        <source>The page around the figure, of a paper of its own</source>
        <translation>Siden rundt figuren, på eget papir</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 biter</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 biter</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Dybde</translation>
    </message>
    <message>
        <source>Of each colour; 16 bits for work that follows</source>
        <translation>For hver farge; 16 biter til videre arbeid</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grått</translation>
    </message>
    <message>
        <source>Without colours, with a grey profile</source>
        <translation>Uten farger, med gråprofil</translation>
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
        <translation>1080 × 1080, kvadratisk</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>En annen størrelse</translation>
    </message>
    <message>
        <source>The page&apos;s shape</source>
        <translation>Sidens form</translation>
    </message>
    <message>
        <source>Width and height in pixels</source>
        <translation>Bredde og høyde i piksler</translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation>Filmens bredde</translation>
    </message>
    <message>
        <source>Of another size</source>
        <translation>Ved en annen størrelse</translation>
    </message>
    <message>
        <source>Of another size, or of the page&apos;s shape</source>
        <translation>Ved en annen størrelse eller sidens form</translation>
    </message>
    <message>
        <source>On sheets alone</source>
        <translation>Bare på ark</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle strukturer</translation>
    </message>
    <message>
        <source>Those with a label</source>
        <translation>De med etikett</translation>
    </message>
    <message>
        <source>Those in focus</source>
        <translation>De i fokus</translation>
    </message>
    <message>
        <source>Colours and names, in the picture&apos;s corner or on the sheet</source>
        <translation>Farger og navn, i hjørnet av bildet eller på arket</translation>
    </message>
    <message>
        <source>Size of the film</source>
        <translation>Filmens størrelse</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Tegnforklaring</translation>
    </message>
    <message>
        <source>Γ over s&amp;urfaces</source>
        <translation>Γ over &amp;flater</translation>
    </message>
    <message>
        <source>By what Γ varies, and how the drawing changes along it</source>
        <translation>Hva Γ varierer etter, og hvordan tegningen endres langs det</translation>
    </message>
    <message>
        <source>Su&amp;btitle file</source>
        <translation>Under&amp;tekstfil</translation>
    </message>
    <message>
        <source>What the views say as a WebVTT file beside the film, for players and web pages</source>
        <translation>Det visningene sier som en WebVTT-fil ved siden av filmen, for avspillere og nettsider</translation>
    </message>
    <message>
        <source>Text of the &amp;view</source>
        <translation>Te&amp;kst til visningen</translation>
    </message>
    <message>
        <source>Title and text of a saved view at the picture&apos;s foot, where it says any; in films as a subtitle</source>
        <translation>Tittel og tekst til en lagret visning nederst i bildet, der den har noen; i filmer som undertekst</translation>
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
        <translation>Lysbildenes form</translation>
    </message>
    <message>
        <source>Width and height of a slide</source>
        <translation>Bredden og høyden på et lysbilde</translation>
    </message>
    <message>
        <source>Labels by clicks</source>
        <translation>Etiketter ved klikk</translation>
    </message>
    <message>
        <source>Labels appear one by one, each with a click, in the scene&apos;s order</source>
        <translation>Etiketter kommer én etter én, hver med et klikk, i scenens rekkefølge</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selvtest</translation>
    </message>
    <message>
        <source>After each slide one with numbers in place of its labels, and then the key</source>
        <translation>Etter hvert lysbilde ett med tall i stedet for etikettene, og så fasiten</translation>
    </message>
    <message>
        <source>Which number is it?</source>
        <translation>Hvilket nummer er det?</translation>
    </message>
    <message>
        <source>A card for each name, which asks for its number in the picture</source>
        <translation>Et kort for hvert navn, som spør etter nummeret i bildet</translation>
    </message>
    <message>
        <source>Which name is covered?</source>
        <translation>Hvilket navn er dekket?</translation>
    </message>
    <message>
        <source>A card for each label, which covers its name among the others</source>
        <translation>Et kort for hver betegnelse, som dekker navnet blant de andre</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>Hva er dette?</translation>
    </message>
    <message>
        <source>A card for each label, which marks the place and asks what it is</source>
        <translation>Et kort for hver betegnelse, som merker stedet og spør hva det er</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beskrivelse</translation>
    </message>
    <message>
        <source>What the picture shows, for who does not see it; where this is empty, the file says what is seen in the picture, and “off” leaves it out</source>
        <translation>Hva bildet viser, for den som ikke ser det; er feltet tomt, sier filen hva som er å se i bildet, og «off» utelater det</translation>
    </message>
    <message>
        <source>Beside surfaces alone</source>
        <translation>Bare ved flater</translation>
    </message>
    <message>
        <source>In a line</source>
        <translation>På én linje</translation>
    </message>
    <message>
        <source>On a page of their own</source>
        <translation>På en egen side</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Ingen steder</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Kilder</translation>
    </message>
    <message>
        <source>Whose work the surfaces are and under what terms</source>
        <translation>Hvem som har laget flatene, og på hvilke vilkår</translation>
    </message>
    <message>
        <source>All with a label</source>
        <translation>Alt med betegnelse</translation>
    </message>
    <message>
        <source>Test asks for</source>
        <translation>Testen spør etter</translation>
    </message>
    <message>
        <source>The fewer, the easier</source>
        <translation>Jo færre, desto lettere</translation>
    </message>
    <message>
        <source>Of these alone</source>
        <translation>Bare av disse</translation>
    </message>
    <message>
        <source>Names of structures or groups, with commas; empty: of all</source>
        <translation>Navn på strukturer eller grupper, med komma; tomt: av alle</translation>
    </message>
    <message>
        <source>&amp;Callouts, too</source>
        <translation>Også te&amp;kstfelt</translation>
    </message>
    <message>
        <source>Callouts explain; only labels name what can be asked for</source>
        <translation>Tekstfelt forklarer; bare betegnelser navngir det man kan spørre etter</translation>
    </message>
    <message>
        <source>After each test</source>
        <translation>Etter hver test</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Til slutt</translation>
    </message>
    <message>
        <source>Word bank</source>
        <translation>Ordliste</translation>
    </message>
    <message>
        <source>The self-test has the answers below, in another order</source>
        <translation>Under egentesten står svarene i en annen rekkefølge</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Fasit</translation>
    </message>
    <message>
        <source>Where the answers stand, each test&apos;s on a page of its own</source>
        <translation>Hvor svarene står, de til hver test på en egen side</translation>
    </message>
    <message>
        <source>Beside names and labels</source>
        <translation>Ved siden av navnene</translation>
    </message>
    <message>
        <source>Nothing else, no names</source>
        <translation>Ikke noe annet, ingen navn</translation>
    </message>
    <message>
        <source>&amp;Quiz</source>
        <translation>&amp;Quiz</translation>
    </message>
    <message>
        <source>What the page asks; alone, no name of a structure is in its file</source>
        <translation>Hva siden spør om; alene står ingen navn på strukturer i filen</translation>
    </message>
    <message>
        <source>Where is it?</source>
        <translation>Hvor er det?</translation>
    </message>
    <message>
        <source>The quiz names something, and it is clicked</source>
        <translation>Quizen nevner noe som klikkes på</translation>
    </message>
    <message>
        <source>What is it? Typed</source>
        <translation>Hva er det? Skrives</translation>
    </message>
    <message>
        <source>The quiz lights something up, and its name is typed</source>
        <translation>Quizen fremhever noe, og navnet skrives</translation>
    </message>
    <message>
        <source>What is it? One of four</source>
        <translation>Hva er det? Én av fire</translation>
    </message>
    <message>
        <source>The other three names are of neighbours and of the same kind</source>
        <translation>De tre andre navnene er på naboer og av samme slag</translation>
    </message>
    <message>
        <source>Order along a path</source>
        <translation>Rekkefølge langs en vei</translation>
    </message>
    <message>
        <source>Where a group is a chain of vessels, the quiz asks for their order</source>
        <translation>Der en gruppe er en kjede av kar, spør quizen om rekkefølgen</translation>
    </message>
    <message>
        <source>Labels to their places</source>
        <translation>Etiketter på plass</translation>
    </message>
    <message>
        <source>Labels are dragged to what they name</source>
        <translation>Etiketter dras til det de navngir</translation>
    </message>
    <message>
        <source>Answers count</source>
        <translation>Svar teller</translation>
    </message>
    <message>
        <source>The page tells how many were right</source>
        <translation>Siden sier hvor mange som var riktige</translation>
    </message>
    <message>
        <source>No turning meanwhile</source>
        <translation>Ingen dreiing imens</translation>
    </message>
    <message>
        <source>While something is asked, the anatomy cannot be turned</source>
        <translation>Mens det spørres, kan anatomien ikke dreies</translation>
    </message>
    <message>
        <source>No hiding meanwhile</source>
        <translation>Ingen skjuling imens</translation>
    </message>
    <message>
        <source>While something is asked, nothing can be hidden and no Γ changed</source>
        <translation>Mens det spørres, kan ingenting skjules og ingen Γ endres</translation>
    </message>
    <message>
        <source>Title of the page</source>
        <translation>Sidens tittel</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>As in “de, la”; empty: all in which there are names</source>
        <translation>Som i «de, la»; tomt: alle der det finnes navn</translation>
    </message>
    <message>
        <source>Triangles at most</source>
        <translation>Trekanter høyst</translation>
    </message>
    <message>
        <source>Fewer make a smaller file and a quicker page; 0: all there are</source>
        <translation>Færre gir en mindre fil og en raskere side; 0: alle som finnes</translation>
    </message>
    <message>
        <source>Surfaces off by</source>
        <translation>Flater avviker med</translation>
    </message>
    <message>
        <source>Surfaces that may be a little off need fewer triangles; 0: exact</source>
        <translation>Flater som kan avvike litt, trenger færre trekanter; 0: nøyaktig</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Bestått fra</translation>
    </message>
    <message>
        <source>The share of right answers that the learning system takes as passed</source>
        <translation>Andelen riktige svar som læringssystemet regner som bestått</translation>
    </message>
    <message>
        <source>Else what the group that holds all is called, or where there is none the file</source>
        <translation>Ellers det gruppen heter som inneholder alt, eller filen der det ikke er noen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Oppløsning</translation>
    </message>
    <message>
        <source>Pixels to the inch of PNG and TIFF; journals ask for 300 or 600, and for up to 1200 where there are lines alone</source>
        <translation>Piksler per tomme i PNG og TIFF; tidsskrifter ber om 300 eller 600, og inntil 1200 der det bare er streker</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>1 bit, ink or paper</source>
        <translation>1 bit, blekk eller papir</translation>
    </message>
    <message>
        <source>1 bit is for black and white figures, as printers take line art</source>
        <translation>1 bit er for figurer i svart-hvitt, slik trykkerier tar strektegninger</translation>
    </message>
</context>
<context>
    <name>sline::widgets</name>
    <message>
        <source>Silhouette</source>
        <translation>Silhuett</translation>
    </message>
    <message>
        <source>The outer edge alone</source>
        <translation>Bare ytterkanten</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturer</translation>
    </message>
    <message>
        <source>Every edge that faces away</source>
        <translation>Hver kant som vender bort</translation>
    </message>
    <message>
        <source>Suggestive contours</source>
        <translation>Suggestive konturer</translation>
    </message>
    <message>
        <source>Lines along folds as well</source>
        <translation>Også linjer langs folder</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Skravering</translation>
    </message>
    <message>
        <source>Tone by strokes</source>
        <translation>Toner av streker</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Skyggelegging</translation>
    </message>
    <message>
        <source>Colour behind lines and strokes</source>
        <translation>Farge bak linjer og streker</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Overflate</translation>
    </message>
    <message>
        <source>The shaded surface alone</source>
        <translation>Bare den skyggelagte overflaten</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Utseende</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Light or dark controls; the picture has a background of its own</source>
        <translation>Lyse eller mørke kontroller; bildet har sin egen bakgrunn</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Som systemet</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lyst</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mørk</translation>
    </message>
    <message>
        <source>Text under the toolbar’s icons</source>
        <translation>Tekst under ikonene på verktøylinjen</translation>
    </message>
    <message>
        <source>What each button does in a word</source>
        <translation>Hva hver knapp gjør, med ett ord</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bilde</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Bakgrunn</translation>
    </message>
    <message>
        <source>What the picture is drawn on; on the dark one ink is light</source>
        <translation>Det bildet tegnes på; på mørk bunn er blekket lyst</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Hvit</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papir</translation>
    </message>
    <message>
        <source>Pelvis of a Woman</source>
        <translation>Bekken hos en kvinne</translation>
    </message>
    <message>
        <source>Pelvis of a Man</source>
        <translation>Bekken hos en mann</translation>
    </message>
    <message>
        <source>Abdomen of a Woman</source>
        <translation>Buk hos en kvinne</translation>
    </message>
    <message>
        <source>Abdomen of a Man</source>
        <translation>Buk hos en mann</translation>
    </message>
    <message>
        <source>Kidney</source>
        <translation>Nyre</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fil</translation>
    </message>
    <message>
        <source>&amp;Demo</source>
        <translation>&amp;Demo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Rediger</translation>
    </message>
    <message>
        <source>&amp;Structure</source>
        <translation>&amp;Struktur</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visning</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>&amp;Lagrede visninger</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>&amp;Snitt</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>Bak&amp;grunn</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>&amp;Paneler</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjelp</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Verktøylinje</translation>
    </message>
    <message>
        <source>&amp;Open Files…</source>
        <translation>&amp;Åpne filer …</translation>
    </message>
    <message>
        <source>Open &amp;Folder…</source>
        <translation>Åpne &amp;mappe …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Open all meshes in a folder</source>
        <translation>Åpne alle nett i en mappe</translation>
    </message>
    <message>
        <source>Read meshes again whose files have changed</source>
        <translation>Les nett på nytt når filene er endret</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avslutt</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Lukk programmet</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Angre</translation>
    </message>
    <message>
        <source>Take the last step back</source>
        <translation>Ta tilbake siste trinn</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gjør om</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Gjør trinnet igjen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Innstillinger …</translation>
    </message>
    <message>
        <source>Theme, background and other habits</source>
        <translation>Tema, bakgrunn og andre vaner</translation>
    </message>
    <message>
        <source>&amp;Find Structure</source>
        <translation>&amp;Finn struktur</translation>
    </message>
    <message>
        <source>Type a few letters of a name</source>
        <translation>Skriv noen bokstaver av et navn</translation>
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
        <translation>&amp;Kontekst</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>The selected structures as contours</source>
        <translation>De valgte strukturene som konturer</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Ta Γ fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Show or &amp;Hide</source>
        <translation>Vis eller skj&amp;ul</translation>
    </message>
    <message>
        <source>Hide the selected structures, or show them again (Space in the list)</source>
        <translation>Skjul de valgte strukturene, eller vis dem igjen (mellomrom i listen)</translation>
    </message>
    <message>
        <source>I&amp;solate</source>
        <translation>I&amp;soler</translation>
    </message>
    <message>
        <source>/</source>
        <translation>/</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>Vis &amp;alle</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Hide nothing</source>
        <translation>Skjul ingenting</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>F&amp;jern</translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene</source>
        <translation>Ta de valgte strukturene ut av scenen</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Forfra</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Seen from the front</source>
        <translation>Sett forfra</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Bakfra</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Seen from the back</source>
        <translation>Sett bakfra</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Fra &amp;venstre</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s left</source>
        <translation>Sett fra pasientens venstre side</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Fra &amp;høyre</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Seen from the patient&apos;s right</source>
        <translation>Sett fra pasientens høyre side</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Ovenfra</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Seen from above</source>
        <translation>Sett ovenfra</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Nedenfra</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Seen from below</source>
        <translation>Sett nedenfra</translation>
    </message>
    <message>
        <source>&amp;Fit All</source>
        <translation>&amp;Tilpass alt</translation>
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
        <translation>Få alt som vises inn i bildet</translation>
    </message>
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittalt</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Cut in the plane between left and right; again: whole</source>
        <translation>Skjær i planet mellom venstre og høyre; en gang til: hel</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Koronalt</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>Cut in the plane between front and back; again: whole</source>
        <translation>Skjær i planet mellom foran og bak; en gang til: hel</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Aksialt</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Cut in the plane between upper and lower; again: whole</source>
        <translation>Skjær i planet mellom øvre og nedre; en gang til: hel</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Vend</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Keep the other side of each section</source>
        <translation>Behold den andre siden av hvert snitt</translation>
    </message>
    <message>
        <source>&amp;Whole Again</source>
        <translation>&amp;Hel igjen</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Take all sections away</source>
        <translation>Ta bort alle snitt</translation>
    </message>
    <message>
        <source>&amp;Key Light</source>
        <translation>Hove&amp;dlys</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Light from the upper left on what is shaded</source>
        <translation>Lys ovenfra til venstre på det som er skyggelagt</translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation>&amp;Mus og taster</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Hva musen og tastene gjør</translation>
    </message>
    <message>
        <source>&amp;About Sline</source>
        <translation>&amp;Om Sline</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Hva dette programmet er</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Dra med venstre</translation>
    </message>
    <message>
        <source>Turn around the pivot</source>
        <translation>Drei rundt dreiepunktet</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Flytt bildet</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Hjul</translation>
    </message>
    <message>
        <source>Zoom to the mouse</source>
        <translation>Zoom mot musen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klikk</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Dobbeltklikk</translation>
    </message>
    <message>
        <source>Turn around this place from now on</source>
        <translation>Drei rundt dette stedet fra nå av</translation>
    </message>
    <message>
        <source>Show or hide the selected structures</source>
        <translation>Vis eller skjul de valgte strukturene</translation>
    </message>
    <message>
        <source>Escape during a drag</source>
        <translation>Esc mens du drar</translation>
    </message>
    <message>
        <source>As it was before</source>
        <translation>Som det var før</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Grensesnitt</translation>
    </message>
    <message>
        <source>The language of menus and texts; takes effect at once</source>
        <translation>Språket i menyer og tekster; gjelder straks</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturer</translation>
    </message>
    <message>
        <source>What known structures are called on screen; files keep their own names</source>
        <translation>Hva kjente strukturer heter på skjermen; filer beholder sine egne navn</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Som i filen</translation>
    </message>
    <message>
        <source>In the interface’s language</source>
        <translation>På grensesnittets språk</translation>
    </message>
    <message>
        <source>Latin</source>
        <translation>Latin</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Engelsk</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Tysk</translation>
    </message>
    <message>
        <source>Dutch</source>
        <translation>Nederlandsk</translation>
    </message>
    <message>
        <source>Norwegian</source>
        <translation>Norsk</translation>
    </message>
    <message>
        <source>hides up to %1 % of it</source>
        <translation>dekker inntil %1 % av det</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Valgt</translation>
    </message>
    <message>
        <source>Thin and long, comes to it</source>
        <translation>Tynn og lang, fører dit</translation>
    </message>
    <message>
        <source>Where %1 comes from</source>
        <translation>Der %1 kommer fra</translation>
    </message>
    <message>
        <source>Lies against it</source>
        <translation>Ligger inntil</translation>
    </message>
    <message>
        <source>Lies outside, %1</source>
        <translation>Ligger utenfor, %1</translation>
    </message>
    <message>
        <source>In focus</source>
        <translation>I fokus</translation>
    </message>
    <message>
        <source>Neighbour</source>
        <translation>Nabo</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Naboer</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Skall</translation>
    </message>
    <message>
        <source>Shells around it</source>
        <translation>Skall rundt</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Bakgrunn</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Filer</translation>
    </message>
    <message>
        <source>Its rights do not let it be written to</source>
        <translation>Rettighetene tillater ikke skriving</translation>
    </message>
    <message>
        <source>Another program has changed it since</source>
        <translation>Et annet program har endret den siden</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>«%1» finnes fra før. Vil du erstatte den?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>Open Files</source>
        <translation>Åpne filer</translation>
    </message>
    <message>
        <source>Meshes and scenes (%1);;All files (*)</source>
        <translation>Nett og scener (%1);;Alle filer (*)</translation>
    </message>
    <message>
        <source>Open Folder</source>
        <translation>Åpne mappe</translation>
    </message>
    <message>
        <source>Sline scenes (*.sline)</source>
        <translation>Sline-scener (*.sline)</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Vil du lagre endringene i «%1»?</translation>
    </message>
    <message>
        <source>Changes that are not saved will be lost.</source>
        <translation>Endringer som ikke lagres, går tapt.</translation>
    </message>
    <message>
        <source>Go back to “%1” as it was saved last?</source>
        <translation>Vil du gå tilbake til «%1» slik den sist ble lagret?</translation>
    </message>
    <message>
        <source>Undo brings back what was changed since.</source>
        <translation>Angre henter tilbake det som er endret siden.</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Tilbakestill</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Sist &amp;brukte</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>A scene without anything in it</source>
        <translation>En scene uten noe i</translation>
    </message>
    <message>
        <source>Open scenes, meshes, label volumes and other files</source>
        <translation>Åpne scener, nett, etikettvolumer og andre filer</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Lagre</translation>
    </message>
    <message>
        <source>Write the scene file</source>
        <translation>Skriv scenefilen</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Lagre &amp;som …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Write another scene file and go on with that</source>
        <translation>Skriv en annen scenefil og fortsett med den</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>Lagre en k&amp;opi …</translation>
    </message>
    <message>
        <source>Write another scene file and go on with this one</source>
        <translation>Skriv en annen scenefil og fortsett med denne</translation>
    </message>
    <message>
        <source>Re&amp;vert to Saved…</source>
        <translation>&amp;Tilbake til lagret …</translation>
    </message>
    <message>
        <source>Read the scene file again; what was changed since is undone</source>
        <translation>Les scenefilen på nytt; det som er endret siden, er borte</translation>
    </message>
    <message>
        <source>Recover &amp;Unsaved Work…</source>
        <translation>Gjenopprett &amp;ulagret arbeid …</translation>
    </message>
    <message>
        <source>What was kept when the program did not end as it should</source>
        <translation>Det som ble tatt vare på da programmet ikke avsluttet som det skulle</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Lu&amp;kk</translation>
    </message>
    <message>
        <source>Close the scene and go to the start page</source>
        <translation>Lukk scenen og gå til startsiden</translation>
    </message>
    <message>
        <source>The selected structures in detail, everything else by what it is to them</source>
        <translation>De valgte strukturene i detalj, alt annet etter hva det er for dem</translation>
    </message>
    <message>
        <source>&amp;Help on This</source>
        <translation>&amp;Hjelp om dette</translation>
    </message>
    <message>
        <source>The page about the panel that has the keyboard</source>
        <translation>Siden om panelet som har tastaturet</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Skåret bort</translation>
    </message>
    <message>
        <source>Orientation cube</source>
        <translation>Orienteringskube</translation>
    </message>
    <message>
        <source>The body&apos;s sides in the corner of the picture; a click looks from there</source>
        <translation>Kroppens sider i hjørnet av bildet; et klikk ser derfra</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Målestokk</translation>
    </message>
    <message>
        <source>True at the depth of what the picture turns around</source>
        <translation>Gjelder i dybden der bildet dreier</translation>
    </message>
    <message>
        <source>Names under the mouse</source>
        <translation>Navn under musen</translation>
    </message>
    <message>
        <source>What a structure is called where the mouse rests</source>
        <translation>Hva en struktur heter der musen hviler</translation>
    </message>
    <message>
        <source>Time that a picture takes</source>
        <translation>Tiden et bilde tar</translation>
    </message>
    <message>
        <source>In milliseconds, in the corner of the picture</source>
        <translation>I millisekunder, i hjørnet av bildet</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mus</translation>
    </message>
    <message>
        <source>Mouse buttons as in</source>
        <translation>Museknapper som i</translation>
    </message>
    <message>
        <source>Which buttons and keys turn, move and zoom the picture; H shows them</source>
        <translation>Hvilke knapper og taster som dreier, flytter og zoomer bildet; H viser dem</translation>
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
        <translation>Korte overganger mellom visninger</translation>
    </message>
    <message>
        <source>Off: the picture changes at once</source>
        <translation>Av: bildet skifter straks</translation>
    </message>
    <message>
        <source>Sagittal section</source>
        <translation>Sagittalt snitt</translation>
    </message>
    <message>
        <source>Coronal section</source>
        <translation>Koronalt snitt</translation>
    </message>
    <message>
        <source>Axial section</source>
        <translation>Aksialt snitt</translation>
    </message>
    <message>
        <source>Oblique section</source>
        <translation>Skrått snitt</translation>
    </message>
    <message>
        <source>Whole scene</source>
        <translation>Hele scenen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skjul</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Lås opp</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoler</translation>
    </message>
    <message>
        <source>Hide Others</source>
        <translation>Skjul andre</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Vis alle</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Skygge</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Arv Γ</translation>
    </message>
    <message>
        <source>Inherit Colour</source>
        <translation>Arv farge</translation>
    </message>
    <message>
        <source>Inherit Opacity</source>
        <translation>Arv dekkevne</translation>
    </message>
    <message>
        <source>Inherit All</source>
        <translation>Arv alt</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Løs opp gruppe</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Flytt</translation>
    </message>
    <message>
        <source>%1, its own</source>
        <translation>%1, egen</translation>
    </message>
    <message>
        <source>%1, inherited</source>
        <translation>%1, arvet</translation>
    </message>
    <message>
        <source>open</source>
        <translation>åpen</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>dekkende</translation>
    </message>
    <message>
        <source>tint</source>
        <translation>tone</translation>
    </message>
    <message>
        <source>veil</source>
        <translation>slør</translation>
    </message>
    <message>
        <source>simplified from %1 triangles, at most %2 mm off</source>
        <translation>forenklet fra %1 trekanter, høyst %2 mm feil</translation>
    </message>
    <message>
        <source>smoothed in %1 steps, at most %2 mm off</source>
        <translation>glattet i %1 trinn, høyst %2 mm feil</translation>
    </message>
    <message>
        <source>refined in %1 steps</source>
        <translation>forfinet i %1 trinn</translation>
    </message>
    <message>
        <source>%1 faces mended</source>
        <translation>%1 flater reparert</translation>
    </message>
    <message>
        <source>moved as its scene says</source>
        <translation>flyttet slik scenen sier</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>som i filen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>made by the program</source>
        <translation>laget av programmet</translation>
    </message>
    <message>
        <source>Part of the file</source>
        <translation>Del av filen</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinater</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhet</translation>
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
        <translation>Farge</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Dekkevne</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Between the lines</source>
        <translation>Mellom linjene</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linjebredde</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Vist</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nei</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Låst</translation>
    </message>
    <message>
        <source>by the group above</source>
        <translation>av gruppen over</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
    <message>
        <source>In</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trekanter</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Størrelse</translation>
    </message>
    <message>
        <source>none: the surface has holes</source>
        <translation>ingen: overflaten har hull</translation>
    </message>
    <message>
        <source>%1, of %2 closed surfaces</source>
        <translation>%1, av %2 lukkede overflater</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volum</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Dra med midtknappen</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Dra med høyre</translation>
    </message>
    <message>
        <source>Zoom: upwards is nearer</source>
        <translation>Zoom: oppover er nærmere</translation>
    </message>
    <message>
        <source>Roll the picture around its middle</source>
        <translation>Rull bildet rundt midten</translation>
    </message>
    <message>
        <source>Two fingers on a touchpad</source>
        <translation>To fingre på en styreplate</translation>
    </message>
    <message>
        <source>Move the picture; pinch to zoom</source>
        <translation>Flytt bildet; klyp for å zoome</translation>
    </message>
    <message>
        <source>Select what is seen there</source>
        <translation>Velg det som ses der</translation>
    </message>
    <message>
        <source>Add to the selection, or take away from it</source>
        <translation>Legg til utvalget, eller ta bort fra det</translation>
    </message>
    <message>
        <source>Select the next structure behind; after the last the first</source>
        <translation>Velg neste struktur bak; etter den siste den første</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Høyreklikk</translation>
    </message>
    <message>
        <source>Drag the arrow of a section</source>
        <translation>Dra pilen til et snitt</translation>
    </message>
    <message>
        <source>Move the plane; with Ctrl in whole steps</source>
        <translation>Flytt planet; med Ctrl i hele trinn</translation>
    </message>
    <message>
        <source>Click on the arrow&apos;s head</source>
        <translation>Klikk på pilspissen</translation>
    </message>
    <message>
        <source>Keep the other side of the section</source>
        <translation>Behold den andre siden av snittet</translation>
    </message>
    <message>
        <source>Drag a ring of a section</source>
        <translation>Dra en ring på et snitt</translation>
    </message>
    <message>
        <source>Tilt the plane; with Ctrl in steps of 15°</source>
        <translation>Vipp planet; med Ctrl i trinn på 15°</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Piltaster</translation>
    </message>
    <message>
        <source>Turn by %1°</source>
        <translation>Drei %1°</translation>
    </message>
    <message>
        <source>Plus, minus</source>
        <translation>Pluss, minus</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>&amp;Inherit</source>
        <translation>Ar&amp;v</translation>
    </message>
    <message>
        <source>&amp;Over the Picture</source>
        <translation>Over b&amp;ildet</translation>
    </message>
    <message>
        <source>Re&amp;load from Source</source>
        <translation>Last &amp;inn på nytt fra kilden</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>Sk&amp;ygge</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>The selected structures as outlines under a veil</source>
        <translation>De valgte strukturene som omriss under et slør</translation>
    </message>
    <message>
        <source>Co&amp;lour…</source>
        <translation>Fa&amp;rge …</translation>
    </message>
    <message>
        <source>Another colour for the selected</source>
        <translation>En annen farge for de valgte</translation>
    </message>
    <message>
        <source>Inherit &amp;Γ</source>
        <translation>Arv &amp;Γ</translation>
    </message>
    <message>
        <source>Inherit &amp;Colour</source>
        <translation>Arv &amp;farge</translation>
    </message>
    <message>
        <source>Take the colour from the group above again</source>
        <translation>Ta fargen fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Inherit &amp;Opacity</source>
        <translation>Arv &amp;dekkevne</translation>
    </message>
    <message>
        <source>Take the opacity from the group above again</source>
        <translation>Ta dekkevnen fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Inherit &amp;All</source>
        <translation>Arv &amp;alt</translation>
    </message>
    <message>
        <source>Take the whole look from the group above again</source>
        <translation>Ta hele utseendet fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Show the selected structures and nothing else; again: everything</source>
        <translation>Vis de valgte strukturene og ikke noe annet; en gang til: alt</translation>
    </message>
    <message>
        <source>Hide &amp;Others</source>
        <translation>Skjul an&amp;dre</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Hide all but the selected structures</source>
        <translation>Skjul alle andre enn de valgte strukturene</translation>
    </message>
    <message>
        <source>&amp;Zoom To</source>
        <translation>&amp;Zoom til</translation>
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
        <translation>Få de valgte strukturene inn i bildet, og drei rundt dem</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Gi &amp;nytt navn</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Another name</source>
        <translation>Et annet navn</translation>
    </message>
    <message>
        <source>Ne&amp;w Group</source>
        <translation>Ny grupp&amp;e</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>An empty group</source>
        <translation>En tom gruppe</translation>
    </message>
    <message>
        <source>Grou&amp;p</source>
        <translation>Grup&amp;per</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>The selected structures in a group of their own</source>
        <translation>De valgte strukturene i en egen gruppe</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>&amp;Løs opp gruppe</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Dissolve the selected groups; what is in them keeps its look</source>
        <translation>Løs opp de valgte gruppene; det som er i dem, beholder utseendet</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>L&amp;ås</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>What is locked keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Det som er låst, beholder utseende, navn og plass og kan ikke klikkes i bildet</translation>
    </message>
    <message>
        <source>Alt+Return</source>
        <translation>Alt+Return</translation>
    </message>
    <message>
        <source>Where it came from, how large it is, how it is drawn</source>
        <translation>Hvor den kom fra, hvor stor den er, hvordan den tegnes</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Cut across the line of sight</source>
        <translation>Skjær på tvers av synslinjen</translation>
    </message>
    <message>
        <source>&amp;Orientation Cube</source>
        <translation>&amp;Orienteringskube</translation>
    </message>
    <message>
        <source>Scale &amp;Bar</source>
        <translation>&amp;Målestokk</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Hvor lang en centimeter er</translation>
    </message>
    <message>
        <source>&amp;Names under the Mouse</source>
        <translation>&amp;Navn under musen</translation>
    </message>
    <message>
        <source>Picture &amp;Time</source>
        <translation>Bilde&amp;tid</translation>
    </message>
    <message>
        <source>How long the last picture took to draw</source>
        <translation>Hvor lang tid det tok å tegne det siste bildet</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Mellomrom</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Bring the selected structures into the picture</source>
        <translation>Få de valgte strukturene inn i bildet</translation>
    </message>
    <message>
        <source>Drag over eyes or locks</source>
        <translation>Dra over øyne eller låser</translation>
    </message>
    <message>
        <source>Set them all alike</source>
        <translation>Sett alle likt</translation>
    </message>
    <message>
        <source>Alt + click on an eye</source>
        <translation>Alt + klikk på et øye</translation>
    </message>
    <message>
        <source>Show this and nothing else; again: everything</source>
        <translation>Vis dette og ikke noe annet; en gang til: alt</translation>
    </message>
    <message>
        <source>Middle click on Γ or colour</source>
        <translation>Midtklikk på Γ eller farge</translation>
    </message>
    <message>
        <source>Take it from the group above again</source>
        <translation>Ta det fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Drag rows</source>
        <translation>Dra rader</translation>
    </message>
    <message>
        <source>Put them elsewhere, or into another group</source>
        <translation>Legg dem et annet sted, eller i en annen gruppe</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Dobbeltklikk på et navn</translation>
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
        <translation>Ny gruppe</translation>
    </message>
    <message>
        <source>How wide lines are, times the usual; 0 draws none</source>
        <translation>Hvor brede linjer er, ganger det vanlige; 0 tegner ingen</translation>
    </message>
    <message>
        <source>Hatching: strokes</source>
        <translation>Skravering: streker</translation>
    </message>
    <message>
        <source>How many strokes hatching has, times the usual; its tone stays</source>
        <translation>Hvor mange streker skraveringen har, ganger det vanlige; tonen blir</translation>
    </message>
    <message>
        <source>Hatching: tone</source>
        <translation>Skravering: tone</translation>
    </message>
    <message>
        <source>How dark hatching is, times the usual, by the width of its strokes</source>
        <translation>Hvor mørk skraveringen er, ganger det vanlige, ved strekenes bredde</translation>
    </message>
    <message>
        <source>How much of what lies behind the colour is hidden; lines stay</source>
        <translation>Hvor mye av det bak fargen som dekkes; linjene blir</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the shaded surface and of washes</source>
        <translation>For den skyggelagte overflaten og for toner</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Blekk</translation>
    </message>
    <message>
        <source>Of lines and hatching; else black, or light on a dark background</source>
        <translation>For linjer og skravering; ellers svart, eller lyst på mørk bakgrunn</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Fylling</translation>
    </message>
    <message>
        <source>Always show import options</source>
        <translation>Vis alltid importvalg</translation>
    </message>
    <message>
        <source>Before meshes are opened: units, smoothing and what is left out</source>
        <translation>Før nett åpnes: enheter, glatting og hva som utelates</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>Im&amp;porter …</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>See and change what an import would do, before it is done</source>
        <translation>Se og endre hva en import vil gjøre, før den gjøres</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>The same for all meshes in a folder</source>
        <translation>Det samme for alle nett i en mappe</translation>
    </message>
    <message>
        <source>Import Op&amp;tions…</source>
        <translation>Importval&amp;g …</translation>
    </message>
    <message>
        <source>Import what is open once more, with other units, smoothing or choice</source>
        <translation>Importer det som er åpent, en gang til, med andre enheter, annen glatting eller annet utvalg</translation>
    </message>
    <message>
        <source>Proper&amp;ties…</source>
        <translation>E&amp;genskaper …</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>På &amp;tvers av blikket</translation>
    </message>
    <message>
        <source>I&amp;mport Folder…</source>
        <translation>Importer mapp&amp;e …</translation>
    </message>
    <message>
        <source>A&amp;dd View</source>
        <translation>L&amp;egg til visning</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Save what you see as a view: camera, what is shown, Γ, colours and sections</source>
        <translation>Lagre det du ser som en visning: kamera, hva som vises, Γ, farger og snitt</translation>
    </message>
    <message>
        <source>Presen&amp;t</source>
        <translation>P&amp;resenter</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>The saved views one after the other on the whole screen</source>
        <translation>De lagrede visningene etter hverandre på hele skjermen</translation>
    </message>
    <message>
        <source>The scene&apos;s own</source>
        <translation>Scenens egne</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Tekster</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numre</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Etiketter</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message numerus="yes">
        <source>%n structures, seen as in the window.</source>
        <translation>
            <numerusform>%n struktur, sett som i vinduet.</numerusform>
            <numerusform>%n strukturer, sett som i vinduet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures as surfaces.</source>
        <translation>
            <numerusform>%n struktur som overflate.</numerusform>
            <numerusform>%n strukturer som overflater.</numerusform>
        </translation>
    </message>
    <message>
        <source>No labels.</source>
        <translation>Ingen etiketter.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels as numbers.</source>
        <translation>
            <numerusform>%n etikett som nummer.</numerusform>
            <numerusform>%n etiketter som numre.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels as blank lines.</source>
        <translation>
            <numerusform>%n etikett som tom linje.</numerusform>
            <numerusform>%n etiketter som tomme linjer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels in the scene&apos;s own language.</source>
        <translation>
            <numerusform>%n etikett på scenens eget språk.</numerusform>
            <numerusform>%n etiketter på scenens eget språk.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels, language: %1.</source>
        <translation>
            <numerusform>%n etikett, språk: %1.</numerusform>
            <numerusform>%n etiketter, språk: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, as lines and shapes of any sharpness.</source>
        <translation>%1, som linjer og flater, skarpe i alle størrelser.</translation>
    </message>
    <message>
        <source>%1, %2 at %3 dpi.</source>
        <translation>%1, %2 ved %3 dpi.</translation>
    </message>
    <message>
        <source>Names of structures, groups and views are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Navn på strukturer, grupper og visninger står i filen slik scenen har dem. Ingen stier, brukernavn, datoer eller pasientdata.</translation>
    </message>
    <message>
        <source>Nothing is in the file but what is seen: no paths, user names, dates or patient data.</source>
        <translation>I filen står bare det man ser: ingen stier, brukernavn, datoer eller pasientdata.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 piksler</translation>
    </message>
    <message>
        <source>No structure is shown: the picture would be empty.</source>
        <translation>Ingen struktur vises: bildet ville være tomt.</translation>
    </message>
    <message>
        <source>The view “%1” shows no structure: its picture would be empty.</source>
        <translation>Visningen «%1» viser ingen struktur: bildet ville være tomt.</translation>
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
        <translation>Lysbilde 16:9</translation>
    </message>
    <message>
        <source>Journal column</source>
        <translation>Tidsskriftspalte</translation>
    </message>
    <message>
        <source>A1 poster</source>
        <translation>Plakat A1</translation>
    </message>
    <message>
        <source>Say what the file is to be called.</source>
        <translation>Si hva filen skal hete.</translation>
    </message>
    <message>
        <source>The name is too long for a file: take a shorter one.</source>
        <translation>Navnet er for langt for en fil: velg et kortere.</translation>
    </message>
    <message>
        <source>There is no folder “%1”: choose one that is there.</source>
        <translation>Det finnes ingen mappe «%1»: velg en som finnes.</translation>
    </message>
    <message>
        <source>“%1” is a file and no folder: choose a folder.</source>
        <translation>«%1» er en fil og ingen mappe: velg en mappe.</translation>
    </message>
    <message>
        <source>“%1” is a folder: give the file another name.</source>
        <translation>«%1» er en mappe: gi filen et annet navn.</translation>
    </message>
    <message>
        <source>You may not write to “%1”: choose another folder or name.</source>
        <translation>Du har ikke lov til å skrive til «%1»: velg en annen mappe eller et annet navn.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>Eksporte&amp;r …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write pictures, drawings and other files for print, teaching and other programs</source>
        <translation>Skriv bilder, tegninger og andre filer til trykk, undervisning og andre programmer</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Kopi&amp;er bildet</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The picture on the clipboard, with its labels, for other programs</source>
        <translation>Bildet på utklippstavlen, med etikettene, til andre programmer</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>et sted</translation>
    </message>
    <message>
        <source>nothing that is there</source>
        <translation>ingenting som finnes</translation>
    </message>
    <message>
        <source>Callout</source>
        <translation>Forklaring</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Nål</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Avstand</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etikett</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The scene’s own</source>
        <translation>Scenens egen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketter</translation>
    </message>
    <message>
        <source>Labels show</source>
        <translation>Etiketter viser</translation>
    </message>
    <message>
        <source>Numbers are for a key beside the picture, blank lines for a test</source>
        <translation>Numre er for en tegnforklaring ved siden av bildet, tomme linjer for en prøve</translation>
    </message>
    <message>
        <source>Blank lines</source>
        <translation>Tomme linjer</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Ingenting</translation>
    </message>
    <message>
        <source>What labels say, where they have words in that language; else the scene’s own</source>
        <translation>Det etikettene sier, der de har ord på det språket; ellers scenens egne</translation>
    </message>
    <message>
        <source>As the structures</source>
        <translation>Som strukturene</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Skriftstørrelse</translation>
    </message>
    <message>
        <source>As on paper, whatever the size of the picture</source>
        <translation>Som på papir, uansett hvor stort bildet er</translation>
    </message>
    <message>
        <source>S&amp;how as</source>
        <translation>Vis s&amp;om</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>&amp;Etikett</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Click on a structure and type what it is called</source>
        <translation>Klikk på en struktur og skriv hva den heter</translation>
    </message>
    <message>
        <source>&amp;Callout</source>
        <translation>&amp;Forklaring</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Click on a place and type a few lines, which stand in a frame</source>
        <translation>Klikk på et sted og skriv noen linjer, som står i en ramme</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Nål</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>Click on a place to mark it; its text stands beside it</source>
        <translation>Klikk på et sted for å merke det; teksten står ved siden av</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Avstand</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Click on two places to measure between them</source>
        <translation>Klikk på to steder for å måle mellom dem</translation>
    </message>
    <message>
        <source>Label the &amp;Selected</source>
        <translation>Sett etikett på det &amp;valgte</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>The selected structures get labels with their names, where they are best seen</source>
        <translation>De valgte strukturene får etiketter med navnene sine, der de synes best</translation>
    </message>
    <message>
        <source>&amp;Edit Text</source>
        <translation>&amp;Rediger tekst</translation>
    </message>
    <message>
        <source>Type what the chosen label says (F2 in the picture)</source>
        <translation>Skriv hva den valgte etiketten sier (F2 i bildet)</translation>
    </message>
    <message>
        <source>Dele&amp;te Label</source>
        <translation>&amp;Slett etiketten</translation>
    </message>
    <message>
        <source>Take the chosen label away (Del in the picture)</source>
        <translation>Ta bort den valgte etiketten (Del i bildet)</translation>
    </message>
    <message>
        <source>Author and rights are in the file as you typed them.</source>
        <translation>Opphav og rettigheter står i filen slik du skrev dem.</translation>
    </message>
    <message>
        <source>the view&apos;s name</source>
        <translation>visningens navn</translation>
    </message>
    <message>
        <source>the scale bar</source>
        <translation>målestokken</translation>
    </message>
    <message>
        <source>the legend</source>
        <translation>tegnforklaringen</translation>
    </message>
    <message>
        <source>what sections have taken away</source>
        <translation>hva snitt har tatt bort</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 og %n til</numerusform>
            <numerusform>%1 og %n til</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room: %1.</source>
        <translation>
            <numerusform>%n etikett fikk ikke plass: %1.</numerusform>
            <numerusform>%n etiketter fikk ikke plass: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are left out, as nothing is drawn there: %1.</source>
        <translation>
            <numerusform>%n etikett er utelatt, for der er ingenting tegnet: %1.</numerusform>
            <numerusform>%n etiketter er utelatt, for der er ingenting tegnet: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels point to places beside the picture: %1.</source>
        <translation>
            <numerusform>%n etikett peker på et sted utenfor bildet: %1.</numerusform>
            <numerusform>%n etiketter peker på steder utenfor bildet: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels have no text in the language and stand in the scene&apos;s own: %1.</source>
        <translation>
            <numerusform>%n etikett har ingen tekst på språket og står på scenens eget: %1.</numerusform>
            <numerusform>%n etiketter har ingen tekst på språket og står på scenens eget: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room and have no card: %1.</source>
        <translation>
            <numerusform>%n etikett fikk ikke plass og har ikke noe kort: %1.</numerusform>
            <numerusform>%n etiketter fikk ikke plass og har ikke noe kort: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the picture&apos;s edge there is no room for: %1.</source>
        <translation>Ved bildets kant er det ikke plass til: %1.</translation>
    </message>
    <message>
        <source>R and L are left out: nobody knows the directions of what is drawn.</source>
        <translation>R og L er utelatt: Ingen kjenner retningene til det som er tegnet.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts are shortened: %1.</source>
        <translation>
            <numerusform>%n tekst er forkortet: %1.</numerusform>
            <numerusform>%n tekster er forkortet: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections cut nothing in the file, which holds whole surfaces: %1.</source>
        <translation>
            <numerusform>%n snitt skjærer ingenting i filen, for den har hele overflater: %1.</numerusform>
            <numerusform>%n snitt skjærer ingenting i filen, for den har hele overflater: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is transparent stands on white.</source>
        <translation>Det som er gjennomsiktig, står på hvitt.</translation>
    </message>
    <message>
        <source>This kind has fewer bits than were chosen.</source>
        <translation>Denne typen har færre biter enn det er valgt.</translation>
    </message>
    <message>
        <source>The film is %1 pixels large, as its sides are even numbers.</source>
        <translation>Filmen er %1 piksler stor, for sidene er partall.</translation>
    </message>
    <message>
        <source>The film takes %1 seconds, as it has whole pictures alone.</source>
        <translation>Filmen varer %1 sekunder, for den har bare hele bilder.</translation>
    </message>
    <message>
        <source>Take a larger page, smaller letters, or numbers.</source>
        <translation>Ta en større side, mindre bokstaver eller tall.</translation>
    </message>
    <message>
        <source>Show the structures, or hide the labels, too.</source>
        <translation>Vis strukturene, eller skjul etikettene også.</translation>
    </message>
    <message>
        <source>Choose a view that shows them.</source>
        <translation>Velg en visning som viser dem.</translation>
    </message>
    <message>
        <source>Write them in the list of labels, or choose another language.</source>
        <translation>Skriv dem i listen over etiketter, eller velg et annet språk.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters.</source>
        <translation>Ta en større side eller mindre bokstaver.</translation>
    </message>
    <message>
        <source>Say them when the files are imported.</source>
        <translation>Angi dem når filene importeres.</translation>
    </message>
    <message>
        <source>Write less, or take larger paper.</source>
        <translation>Skriv mindre, eller ta større papir.</translation>
    </message>
    <message>
        <source>Export a picture or a drawing to show the cut.</source>
        <translation>Eksporter et bilde eller en tegning for å vise snittet.</translation>
    </message>
    <message>
        <source>Take PNG, TIFF, SVG or WebP to keep it transparent.</source>
        <translation>Ta PNG, TIFF, SVG eller WebP for å beholde gjennomsiktigheten.</translation>
    </message>
    <message>
        <source>Take PNG or TIFF for more.</source>
        <translation>Ta PNG eller TIFF for flere.</translation>
    </message>
    <message>
        <source>The text is for a patient&apos;s sheet: this one does not have it.</source>
        <translation>Teksten hører til et ark for pasienter: dette arket har den ikke.</translation>
    </message>
    <message>
        <source>&amp;Print Proof…</source>
        <translation>Prø&amp;vetrykk …</translation>
    </message>
    <message>
        <source>Find neighbours that a press without colours or some eyes cannot tell apart, and what would help</source>
        <translation>Finner naboer som et trykk uten farger eller noen øyne ikke kan skille, og hva som ville hjelpe</translation>
    </message>
    <message>
        <source>Files from outside open in</source>
        <translation>Filer utenfra åpnes i</translation>
    </message>
    <message>
        <source>What a file manager or a command names while a window is open</source>
        <translation>Det en filbehandler eller en kommando navngir mens et vindu er åpent</translation>
    </message>
    <message>
        <source>The open window</source>
        <translation>Det åpne vinduet</translation>
    </message>
    <message>
        <source>A window of their own</source>
        <translation>Et eget vindu</translation>
    </message>
    <message>
        <source>Look of what is opened</source>
        <translation>Utseende ved åpning</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plansje</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Enkelt</translation>
    </message>
    <message>
        <source>Dra&amp;w as Plate</source>
        <translation>Tegn som plans&amp;je</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>What the scene is about in detail, seen from where it shows best, everything else as context</source>
        <translation>Det scenen handler om i detalj, sett derfra det vises best, alt annet som omgivelse</translation>
    </message>
    <message>
        <source>Another S&amp;ubject</source>
        <translation>Annet &amp;motiv</translation>
    </message>
    <message>
        <source>A plate of what else the scene may be about; again for the next</source>
        <translation>En plansje av noe annet scenen kan handle om; en gang til for det neste</translation>
    </message>
    <message>
        <source>lesion</source>
        <translation>lesjon</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>organ</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>kar</translation>
    </message>
    <message>
        <source>nerve</source>
        <translation>nerve</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>knokkel</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>ledd</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>muskel</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>hud</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>struktur</translation>
    </message>
    <message>
        <source>the subject</source>
        <translation>motivet</translation>
    </message>
    <message>
        <source>it comes to the subject</source>
        <translation>den kommer til motivet</translation>
    </message>
    <message>
        <source>it is near the subject</source>
        <translation>den er nær motivet</translation>
    </message>
    <message>
        <source>it lies outside and hides the subject</source>
        <translation>den ligger utenfor og skjuler motivet</translation>
    </message>
    <message>
        <source>it is away from the subject</source>
        <translation>den er langt fra motivet</translation>
    </message>
    <message>
        <source>not drawn: more context would show it</source>
        <translation>ikke tegnet: mer kontekst ville vise den</translation>
    </message>
    <message>
        <source>in detail: it is the subject</source>
        <translation>i detalj: det er motivet</translation>
    </message>
    <message>
        <source>solid and pale: the subject lies in it</source>
        <translation>dekkende og blek: motivet ligger i den</translation>
    </message>
    <message>
        <source>outline: %1 in front of the subject</source>
        <translation>omriss: %1 foran motivet</translation>
    </message>
    <message>
        <source>modelled: %1 that comes to the subject</source>
        <translation>modellert: %1 som kommer til motivet</translation>
    </message>
    <message>
        <source>solid: %1 near the subject</source>
        <translation>dekkende: %1 nær motivet</translation>
    </message>
    <message>
        <source>solid and pale: %1 away from the subject</source>
        <translation>dekkende og blek: %1 langt fra motivet</translation>
    </message>
    <message>
        <source>lines: %1</source>
        <translation>linjer: %1</translation>
    </message>
    <message>
        <source>Ligands</source>
        <translation>Ligander</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Lesjoner</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organer</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Ledd</translation>
    </message>
    <message>
        <source>Vessels and nerves</source>
        <translation>Kar og nerver</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knokler</translation>
    </message>
    <message>
        <source>What lies in the organs</source>
        <translation>Det som ligger i organene</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Line weight</source>
        <translation>Strektrykk</translation>
    </message>
    <message>
        <source>How much the pen&apos;s width tells light, depth and form; 0 is an even pen</source>
        <translation>Hvor mye pennens bredde viser lys, dybde og form; 0 er en jevn penn</translation>
    </message>
    <message>
        <source>Line smoothing</source>
        <translation>Linjeglatting</translation>
    </message>
    <message>
        <source>How far lines leave what turns back and forth, times the usual</source>
        <translation>Hvor langt linjer forlater det som svinger fram og tilbake, ganger det vanlige</translation>
    </message>
    <message>
        <source>Shortest line</source>
        <translation>Korteste linje</translation>
    </message>
    <message>
        <source>Shorter pieces of lines are left out; in 1/720 of the picture&apos;s height</source>
        <translation>Kortere linjestykker utelates; i 1/720 av bildets høyde</translation>
    </message>
    <message>
        <source>Line scale</source>
        <translation>Linjeskala</translation>
    </message>
    <message>
        <source>How large a form must be to get suggestive contours, times the usual; 0 draws all that were measured</source>
        <translation>Hvor stor en form må være for å få antydede konturer, ganger det vanlige; 0 tegner alle som ble målt</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>Glorie</translation>
    </message>
    <message>
        <source>How many line widths before its outline lines behind stop</source>
        <translation>Hvor mange linjebredder før omrisset linjer bak stopper</translation>
    </message>
    <message>
        <source>Pencil grain</source>
        <translation>Blyantkorn</translation>
    </message>
    <message>
        <source>How much the pen is a pencil on rough paper</source>
        <translation>Hvor mye pennen er en blyant på grovt papir</translation>
    </message>
    <message>
        <source>Hidden outlines</source>
        <translation>Skjulte omriss</translation>
    </message>
    <message>
        <source>How outlines are drawn where other structures hide them</source>
        <translation>Hvordan omriss tegnes der andre strukturer skjuler dem</translation>
    </message>
    <message>
        <source>Not drawn</source>
        <translation>Ikke tegnet</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Tynn</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Stiplet</translation>
    </message>
    <message>
        <source>Other Sub&amp;jects…</source>
        <translation>&amp;Andre motiver…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+J</source>
        <translation>Ctrl+Shift+J</translation>
    </message>
    <message>
        <source>Small plates of the next three subjects, to choose from</source>
        <translation>Små plansjer av de neste tre motivene å velge mellom</translation>
    </message>
    <message>
        <source>drawn without the steps of slices %1 mm apart, at most %2 mm off</source>
        <translation>tegnet uten trinnene til snitt med %1 mm avstand, høyst %2 mm ved siden av</translation>
    </message>
    <message>
        <source>What the scene is about shaded in colour, everything else as quiet context.</source>
        <translation>Det scenen handler om skyggelagt i farger, alt annet som rolig kontekst.</translation>
    </message>
    <message>
        <source>Even Pen</source>
        <translation>Jevn penn</translation>
    </message>
    <message>
        <source>Outlines and folds in black, all by one pen that never changes its width.</source>
        <translation>Omriss og folder i svart, alle med én penn som aldri endrer bredde.</translation>
    </message>
    <message>
        <source>Textbook</source>
        <translation>Lærebok</translation>
    </message>
    <message>
        <source>Two colours: black lines, and one colour with a pale tint for what the scene is about.</source>
        <translation>To farger: svarte linjer, og én farge med en blek tone for det scenen handler om.</translation>
    </message>
    <message>
        <source>Woodcut</source>
        <translation>Tresnitt</translation>
    </message>
    <message>
        <source>Heavy black lines and dense hatching on white.</source>
        <translation>Kraftige svarte linjer og tett skravering på hvitt.</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Blyant</translation>
    </message>
    <message>
        <source>Fine strokes of graphite on warm paper.</source>
        <translation>Fine grafittstreker på varmt papir.</translation>
    </message>
    <message>
        <source>Operating Note</source>
        <translation>OP-skisse</translation>
    </message>
    <message>
        <source>A few long lines as a surgeon would sketch them, what matters in one colour.</source>
        <translation>Noen få lange linjer slik en kirurg ville skissere dem, det viktige i én farge.</translation>
    </message>
    <message>
        <source>Lecture Hall</source>
        <translation>Forelesningssal</translation>
    </message>
    <message>
        <source>Bright colours on a dark ground, to be seen from the last row.</source>
        <translation>Klare farger på mørk bunn, synlige fra bakerste rad.</translation>
    </message>
    <message>
        <source>What lies inside</source>
        <translation>Det som ligger inni</translation>
    </message>
    <message>
        <source>&amp;All Panels</source>
        <translation>&amp;Alle paneler</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
    <message>
        <source>Hide all panels around the picture, or show them again</source>
        <translation>Skjul alle paneler rundt bildet, eller vis dem igjen</translation>
    </message>
    <message>
        <source>S&amp;elect</source>
        <translation>&amp;Marker</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Alle</translation>
    </message>
    <message>
        <source>Select all structures that are shown and not locked</source>
        <translation>Velg alle strukturer som vises og ikke er låst</translation>
    </message>
    <message>
        <source>&amp;Inverse</source>
        <translation>&amp;Omvendt</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Select what is shown and not selected, in place of what is</source>
        <translation>Velg det som vises og ikke er valgt, i stedet for det som er det</translation>
    </message>
    <message>
        <source>Same &amp;Kind</source>
        <translation>Samme &amp;slag</translation>
    </message>
    <message>
        <source>Shift+G</source>
        <translation>Shift+G</translation>
    </message>
    <message>
        <source>Select what differs from the selected by side or number alone, such as all ribs; again: all of their system</source>
        <translation>Velg det som bare skiller seg fra det valgte ved side eller nummer, som alle ribbein; en gang til: alt i systemet deres</translation>
    </message>
    <message>
        <source>&amp;Other Side</source>
        <translation>Andre si&amp;de</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Select what the selected structures are paired with on the other side of the body</source>
        <translation>Velg motstykkene til de valgte strukturene på den andre siden av kroppen</translation>
    </message>
    <message>
        <source>By a &amp;Box</source>
        <translation>Med en &amp;ramme</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Drag a box in the picture: to the right what lies within, to the left what it touches</source>
        <translation>Dra en ramme i bildet: mot høyre det som ligger i den, mot venstre det den berører</translation>
    </message>
    <message>
        <source>Middle click, Page Down, %1</source>
        <translation>Klikk med midtknappen, Page Down, %1</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Select the next structure before it</source>
        <translation>Velg den neste strukturen foran</translation>
    </message>
    <message>
        <source>Select by a box: to the right what lies within, to the left what it touches; with Ctrl in addition</source>
        <translation>Velg med en ramme: mot høyre det som ligger i den, mot venstre det den berører; med Ctrl i tillegg</translation>
    </message>
    <message>
        <source>What can be done with the structure there, and all that lies there from front to back</source>
        <translation>Hva som kan gjøres med strukturen der, og alt som ligger der fra forrest til bakerst</translation>
    </message>
    <message>
        <source>Serves %1</source>
        <translation>Forsyner: %1</translation>
    </message>
    <message>
        <source>English / Latin</source>
        <translation>Engelsk / latin</translation>
    </message>
    <message>
        <source>German / Latin</source>
        <translation>Tysk / latin</translation>
    </message>
    <message>
        <source>Dutch / Latin</source>
        <translation>Nederlandsk / latin</translation>
    </message>
    <message>
        <source>Norwegian / Latin</source>
        <translation>Norsk / latin</translation>
    </message>
    <message>
        <source>St&amp;yle</source>
        <translation>S&amp;til</translation>
    </message>
    <message>
        <source>&amp;Copy Style</source>
        <translation>&amp;Kopier stilen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>The whole look of the selected structure, for others</source>
        <translation>Hele utseendet til den valgte strukturen, for andre</translation>
    </message>
    <message>
        <source>&amp;Paste Style</source>
        <translation>&amp;Lim inn stilen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied</source>
        <translation>Gi de valgte strukturene utseendet som ble kopiert</translation>
    </message>
    <message>
        <source>Paste Style, &amp;Keep Colour</source>
        <translation>Lim inn stilen, &amp;behold fargen</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+V</source>
        <translation>Ctrl+Alt+Shift+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied, but for colour and ink</source>
        <translation>Gi de valgte strukturene utseendet som ble kopiert, uten farge og blekk</translation>
    </message>
    <message>
        <source>&amp;Make Like…</source>
        <translation>&amp;Gjør lik …</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Click on another structure, in the picture or the list: the selected ones are drawn as it is and keep their colours</source>
        <translation>Klikk på en annen struktur, i bildet eller listen: de valgte tegnes som den og beholder fargene sine</translation>
    </message>
    <message numerus="yes">
        <source>%n labels point with a dashed line to what is hidden in this picture: %1.</source>
        <translation>
            <numerusform>%n etikett peker med stiplet linje på noe som er skjult i dette bildet: %1.</numerusform>
            <numerusform>%n etiketter peker med stiplet linje på noe som er skjult i dette bildet: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that shows it, or draw less of what is before it.</source>
        <translation>Velg en visning som viser det, eller tegn mindre av det som ligger foran.</translation>
    </message>
    <message>
        <source>Where a file says nothing of how it looks: a plate draws what it is about in detail and everything else as context, the other styles in their manner</source>
        <translation>Der en fil ikke sier hvordan den ser ut: En plansje tegner det den handler om i detalj og alt annet som kontekst, de andre stilene på sin måte</translation>
    </message>
    <message>
        <source>Hi&amp;dden Outlines</source>
        <translation>Skjulte &amp;omriss</translation>
    </message>
    <message>
        <source>&amp;Not Drawn</source>
        <translation>&amp;Ikke tegnet</translation>
    </message>
    <message>
        <source>Outlines of the selected end where other structures hide them</source>
        <translation>Omrissene av de valgte slutter der andre strukturer skjuler dem</translation>
    </message>
    <message>
        <source>&amp;Thin</source>
        <translation>&amp;Tynn</translation>
    </message>
    <message>
        <source>Outlines of the selected go on thinly where other structures hide them</source>
        <translation>Omrissene av de valgte fortsetter tynt der andre strukturer skjuler dem</translation>
    </message>
    <message>
        <source>&amp;Dashed</source>
        <translation>&amp;Stiplet</translation>
    </message>
    <message>
        <source>Outlines of the selected go on dashed where other structures hide them</source>
        <translation>Omrissene av de valgte fortsetter stiplet der andre strukturer skjuler dem</translation>
    </message>
    <message>
        <source>Hidden Outlines</source>
        <translation>Skjulte omriss</translation>
    </message>
    <message>
        <source>Keep unsaved work</source>
        <translation>Ta vare på ulagret arbeid</translation>
    </message>
    <message>
        <source>Each change is kept at once, and offered after a crash</source>
        <translation>Hver endring tas vare på med en gang, og tilbys etter et krasj</translation>
    </message>
    <message>
        <source>%1 seconds, %2 × %3 pixels, %4 pictures a second.</source>
        <translation>%1 sekunder, %2 × %3 piksler, %4 bilder i sekundet.</translation>
    </message>
    <message>
        <source>Its size is being measured.</source>
        <translation>Størrelsen måles.</translation>
    </message>
    <message>
        <source>About %1.</source>
        <translation>Omtrent %1.</translation>
    </message>
    <message>
        <source>About %1 each.</source>
        <translation>Omtrent %1 hver.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures found no room in the legend: %1.</source>
        <translation>
            <numerusform>%n struktur fikk ikke plass i tegnforklaringen: %1.</numerusform>
            <numerusform>%n strukturer fikk ikke plass i tegnforklaringen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The legend is empty: nothing that is shown has a label, or is in focus.</source>
        <translation>Tegnforklaringen er tom: ingenting av det som vises har en etikett eller er i fokus.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters, or list fewer.</source>
        <translation>Ta en større side eller mindre bokstaver, eller nevn færre.</translation>
    </message>
    <message>
        <source>Let it list all structures.</source>
        <translation>La den nevne alle strukturer.</translation>
    </message>
    <message>
        <source>The sheet labels what is seen.</source>
        <translation>Arket merker det som er synlig.</translation>
    </message>
    <message>
        <source>Nowhere to be seen in this picture: its leader is dashed.</source>
        <translation>Ikke synlig noe sted i dette bildet: linjen dit er stiplet.</translation>
    </message>
    <message>
        <source>The place set by hand is hidden in this picture: its leader is dashed.</source>
        <translation>Stedet som er satt for hånd, er skjult i dette bildet: linjen dit er stiplet.</translation>
    </message>
    <message>
        <source>Not in this picture: there is no room for it.</source>
        <translation>Ikke i dette bildet: det er ikke plass.</translation>
    </message>
    <message>
        <source>Not in this picture: its place is beyond the edge.</source>
        <translation>Ikke i dette bildet: stedet ligger utenfor kanten.</translation>
    </message>
    <message>
        <source>Not in this picture: nothing is drawn at its place.</source>
        <translation>Ikke i dette bildet: ingenting er tegnet på stedet.</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Teknikk</translation>
    </message>
    <message>
        <source>ConFIS</source>
        <translation>ConFIS</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Tilsynelatende rygger</translation>
    </message>
    <message>
        <source>Ridges and valleys</source>
        <translation>Rygger og daler</translation>
    </message>
    <message>
        <source>Photic extremum lines</source>
        <translation>Fotiske ekstremlinjer</translation>
    </message>
    <message>
        <source>Laplacian lines</source>
        <translation>Laplace-linjer</translation>
    </message>
    <message>
        <source>Demarcating curves</source>
        <translation>Skillekurver</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanslinjer</translation>
    </message>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ over flaten</translation>
    </message>
    <message>
        <source>Thresholds of lines</source>
        <translation>Terskler for linjer</translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>Glanslinjer</translation>
    </message>
    <message>
        <source>Dκr·F² must be above</source>
        <translation>Dκr·F² må være over</translation>
    </message>
    <message>
        <source>acos(nv) must be above, radians</source>
        <translation>acos(nv) må være over, radianer</translation>
    </message>
    <message>
        <source>T/F_c, the thickness of the contour&apos;s margin</source>
        <translation>T/F_c, tykkelsen av randen langs konturen</translation>
    </message>
    <message>
        <source>|H|·F_c must be above where H has an extremum</source>
        <translation>|H|·F_c må være over der H har et ekstremum</translation>
    </message>
    <message>
        <source>the least distance between lines, 1/720 of the picture&apos;s height</source>
        <translation>den minste avstanden mellom linjer, 1/720 av bildehøyden</translation>
    </message>
    <message>
        <source>q1·F must be above</source>
        <translation>q1·F må være over</translation>
    </message>
    <message>
        <source>|κ1|·F must be above</source>
        <translation>|κ1|·F må være over</translation>
    </message>
    <message>
        <source>|κ1&apos;&apos;|/|κ1|³ across the line must be above</source>
        <translation>|κ1&apos;&apos;|/|κ1|³ på tvers av linjen må være over</translation>
    </message>
    <message>
        <source>|∇f|·F must be above</source>
        <translation>|∇f|·F må være over</translation>
    </message>
    <message>
        <source>C(g,g,g)·F² must be above</source>
        <translation>C(g,g,g)·F² må være over</translation>
    </message>
    <message>
        <source>−Dκr·F² must be above</source>
        <translation>−Dκr·F² må være over</translation>
    </message>
    <message>
        <source>κ1²·F² must be above</source>
        <translation>κ1²·F² må være over</translation>
    </message>
    <message>
        <source>Compare Tec&amp;hniques…</source>
        <translation>Teknikker ved siden av &amp;hverandre …</translation>
    </message>
    <message>
        <source>See what is selected, or all, drawn by several line techniques side by side, and save that as a sheet</source>
        <translation>Se det som er valgt, eller alt, tegnet med flere linjeteknikker side om side, og lagre det som et ark</translation>
    </message>
    <message numerus="yes">
        <source>%n structures are drawn without noise, which is made of pixels: %1.</source>
        <translation>
            <numerusform>%n struktur er tegnet uten støy, som består av piksler: %1.</numerusform>
            <numerusform>%n strukturer er tegnet uten støy, som består av piksler: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export a picture, or take streamline hatching.</source>
        <translation>Eksporter et bilde, eller ta strømlinjeskravering.</translation>
    </message>
    <message>
        <source>What draws the form within contours: suggestive contours and hatching, or short streamlines along contours and where the curvature has an extremum, or lines, streamlines and noise that these are compared with</source>
        <translation>Hva som tegner formen innenfor konturene: antydede konturer og skravering, korte strømlinjer langs konturer og der krumningen har et ekstremum, eller linjer, strømlinjer og støy som disse sammenlignes med</translation>
    </message>
    <message>
        <source>Streamline hatching</source>
        <translation>Strømlinjeskravering</translation>
    </message>
    <message>
        <source>Noise LIC</source>
        <translation>Støy-LIC</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Male</translation>
    </message>
    <message>
        <source>Focus by Nearness</source>
        <translation>Fokus etter nærhet</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Det valgte skyggelagt, alt annet mindre detaljert jo lenger unna det er</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nærhet til et sted</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Klikk i bildet for å sette stedet, og dra det; med Shift i dybden</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pensel</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Paint on the selected structures where more is to be told than elsewhere</source>
        <translation>Mal på de valgte strukturene der mer skal fortelles enn andre steder</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation>&amp;Mindre pensel</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>Paint with a smaller brush</source>
        <translation>Mal med en mindre pensel</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>&amp;Større pensel</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>Paint with a larger brush</source>
        <translation>Mal med en større pensel</translation>
    </message>
    <message>
        <source>&amp;Erase with the Brush</source>
        <translation>&amp;Visk ut med penselen</translation>
    </message>
    <message>
        <source>Take away what is painted (Ctrl while you paint)</source>
        <translation>Ta bort det som er malt (Ctrl mens du maler)</translation>
    </message>
    <message>
        <source>the distance between lines in full shade, 1/720 of the picture&apos;s height</source>
        <translation>avstanden mellom linjene i full skygge, 1/720 av bildets høyde</translation>
    </message>
    <message>
        <source>the shade must be above, 0 in the light to 1</source>
        <translation>skyggen må ligge over, 0 i lyset til 1</translation>
    </message>
    <message numerus="yes">
        <source>%n slides, one for each saved view.</source>
        <translation>
            <numerusform>%n lysbilde, ett for hver lagrede visning.</numerusform>
            <numerusform>%n lysbilder, ett for hver lagrede visning.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, labels as text and lines.</source>
        <translation>%1, etiketter som tekst og linjer.</translation>
    </message>
    <message>
        <source>Names, and the views&apos; texts and notes, are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Navn, og visningenes tekster og notater, står i filen slik scenen har dem. Stier, brukernavn, datoer og pasientdata gjør det ikke.</translation>
    </message>
    <message>
        <source>Fi&amp;gure of Several Panels…</source>
        <translation>&amp;Figur med flere felt…</translation>
    </message>
    <message>
        <source>Lay saved views out as panels a, b, c on a page for a journal, with insets, scale bars and one legend</source>
        <translation>Legg lagrede visninger ut som felt a, b, c på en side for et tidsskrift, med utsnitt, målestokker og én tegnforklaring</translation>
    </message>
    <message numerus="yes">
        <source>%n files, one for each saved view: %1 … %2.</source>
        <translation>
            <numerusform>%n fil, én for hver lagrede visning: %1 … %2.</numerusform>
            <numerusform>%n filer, én for hver lagrede visning: %1 … %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views on about %n pages, with contents, index and bookmarks.</source>
        <translation>
            <numerusform>%1 visninger på omtrent %n side, med innhold, register og bokmerker.</numerusform>
            <numerusform>%1 visninger på omtrent %n sider, med innhold, register og bokmerker.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards, in a deck for each view.</source>
        <translation>
            <numerusform>Høyst %n kort, i en kortstokk for hver visning.</numerusform>
            <numerusform>Høyst %n kort, i en kortstokk for hver visning.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards.</source>
        <translation>
            <numerusform>Høyst %n kort.</numerusform>
            <numerusform>Høyst %n kort.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is seen is also told in words, for who does not see it.</source>
        <translation>Det som er å se, står der også i ord, for den som ikke ser det.</translation>
    </message>
    <message>
        <source>The page has %1 million triangles, too many for telephones.</source>
        <translation>Siden har %1 millioner trekanter, for mange for telefoner.</translation>
    </message>
    <message>
        <source>Surfaces are simplified and off by %1 mm at most, which the page says.</source>
        <translation>Flater er forenklet og avviker høyst %1 mm; det sier siden.</translation>
    </message>
    <message>
        <source>The quiz asks nothing, as no label is to be asked for.</source>
        <translation>Quizen spør ikke om noe, for det er ingen etikett å spørre om.</translation>
    </message>
    <message>
        <source>Let surfaces be off by 0.2 mm, or export less.</source>
        <translation>La flater avvike med 0,2 mm, eller eksporter mindre.</translation>
    </message>
    <message>
        <source>Label structures, or choose no quiz.</source>
        <translation>Sett etiketter på strukturer, eller velg ingen quiz.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n questions with pictures.</source>
        <translation>
            <numerusform>Høyst %n spørsmål med bilde.</numerusform>
            <numerusform>Høyst %n spørsmål med bilder.</numerusform>
        </translation>
    </message>
    <message>
        <source>No name of a structure can be read in the file; answers are there as checksums. No paths, user names, dates or patient data are.</source>
        <translation>Ingen navn på strukturer kan leses i filen; svar står der som kontrollsummer. Det gjør ikke stier, brukernavn, datoer eller pasientdata.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as one does not see there what is named: %1.</source>
        <translation>
            <numerusform>%n etikett spørres det ikke etter, fordi man ikke ser det den navngir der: %1.</numerusform>
            <numerusform>%n etiketter spørres det ikke etter, fordi man ikke ser det de navngir der: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Vessel, nerve or duct</source>
        <translation>Kar, nerve eller gang</translation>
    </message>
    <message>
        <source>Vessels, nerves and ducts</source>
        <translation>Kar, nerver og ganger</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 and %n more</source>
        <translation>
            <numerusform>%1: %2 og %n til</numerusform>
            <numerusform>%1: %2 og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n patients. Put them into one scene?</source>
        <translation>
            <numerusform>Disse filene er av %n pasient. Skal de bli én scene?</numerusform>
            <numerusform>Disse filene er av %n pasienter. Skal de bli én scene?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n studies, and nothing says that they are of one patient. Put them into one scene?</source>
        <translation>
            <numerusform>Disse filene er av %n studie, og ingenting sier at de er av én pasient. Skal de bli én scene?</numerusform>
            <numerusform>Disse filene er av %n studier, og ingenting sier at de er av én pasient. Skal de bli én scene?</numerusform>
        </translation>
    </message>
    <message>
        <source>Import Together</source>
        <translation>Importer sammen</translation>
    </message>
    <message>
        <source>Only the First</source>
        <translation>Bare den første</translation>
    </message>
    <message>
        <source>Something in it is at fault and was left out: %1</source>
        <translation>Noe i den er feil og ble utelatt: %1</translation>
    </message>
    <message numerus="yes">
        <source>Something in it is at fault and was left out: %1; and %n more</source>
        <translation>
            <numerusform>Noe i den er feil og ble utelatt: %1; og %n til</numerusform>
            <numerusform>Noe i den er feil og ble utelatt: %1; og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>A newer version of the program has written it; what is unknown here is not shown, and a copy is saved in the form of this version</source>
        <translation>En nyere versjon av programmet har skrevet den; det som er ukjent her, vises ikke, og en kopi lagres i denne versjonens form</translation>
    </message>
    <message>
        <source>It has changed since the program ended with these changes unsaved</source>
        <translation>Den er endret siden programmet ble avsluttet uten at disse endringene var lagret</translation>
    </message>
    <message>
        <source>Whether it has changed since the program ended is not known</source>
        <translation>Om den er endret siden programmet ble avsluttet, er ikke kjent</translation>
    </message>
    <message>
        <source>Left and Ri&amp;ght</source>
        <translation>&amp;Venstre og høyre</translation>
    </message>
    <message>
        <source>Sides Are &amp;Right</source>
        <translation>Sidene &amp;stemmer</translation>
    </message>
    <message>
        <source>What was assumed of left and right is so; marks lose their question marks</source>
        <translation>Det som ble antatt om venstre og høyre, stemmer; merkene mister spørsmålstegnene</translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation>S&amp;peilvend venstre og høyre</translation>
    </message>
    <message>
        <source>Left and right are swapped, front and back are not: the scene becomes its mirror image</source>
        <translation>Venstre og høyre er byttet om, foran og bak ikke: scenen blir sitt speilbilde</translation>
    </message>
    <message>
        <source>&amp;Turn About the Body&apos;s Axis</source>
        <translation>&amp;Drei om kroppens akse</translation>
    </message>
    <message>
        <source>Left and right are swapped, and front and back, too, as where RAS was taken for LPS: half a turn</source>
        <translation>Venstre og høyre er byttet om, foran og bak også, som der RAS ble tatt for LPS: en halv omdreining</translation>
    </message>
    <message>
        <source>%1, of the smoothed surface</source>
        <translation>%1, av den glattede overflaten</translation>
    </message>
    <message>
        <source>Hide the selected structures</source>
        <translation>Skjul de valgte strukturene</translation>
    </message>
    <message>
        <source>In &amp;Focus</source>
        <translation>I &amp;fokus</translation>
    </message>
    <message>
        <source>Select what is in focus</source>
        <translation>Velg det som er i fokus</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>the view&apos;s text</source>
        <translation>visningens tekst</translation>
    </message>
    <message>
        <source>what Γ follows</source>
        <translation>det Γ følger</translation>
    </message>
    <message>
        <source>The picture ends %1 mm above its foot, as what is written there has no other room.</source>
        <translation>Bildet slutter %1 mm over sin nedre kant, fordi det som står der, ikke har annen plass.</translation>
    </message>
    <message>
        <source>Choose a view that leaves room, or leave words or credits out.</source>
        <translation>Velg en visning som gir plass, eller utelat tekst eller kilder.</translation>
    </message>
    <message>
        <source>what is open</source>
        <translation>det som er åpent</translation>
    </message>
    <message>
        <source>or</source>
        <comment>between two wishes of the filter</comment>
        <translation>eller</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Side</translation>
    </message>
    <message>
        <source>another than its name says</source>
        <translation>en annen enn navnet sier</translation>
    </message>
    <message>
        <source>The file does not say whose work its surfaces are, as their terms ask: %1.</source>
        <translation>Filen sier ikke hvem flatene er laget av, slik lisensen deres krever: %1.</translation>
    </message>
    <message>
        <source>The subtitles are empty, as no view says anything.</source>
        <translation>Undertekstene er tomme, for ingen visning sier noe.</translation>
    </message>
    <message>
        <source>Let it say them in a line, or say them where it is published.</source>
        <translation>La det stå på en linje, eller si det der filen blir publisert.</translation>
    </message>
    <message>
        <source>Write what views say.</source>
        <translation>Skriv hva visningene sier.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels stand on anatomy, which leaves no room beside it: %1.</source>
        <translation>
            <numerusform>%n etikett står på anatomi, som ikke gir plass ved siden av: %1.</numerusform>
            <numerusform>%n etiketter står på anatomi, som ikke gir plass ved siden av: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that leaves some, a larger page or smaller letters.</source>
        <translation>Velg en visning som gir plass, et større ark eller mindre bokstaver.</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 unna</translation>
    </message>
    <message>
        <source>%1 (right–left, front–back, foot–head)</source>
        <translation>%1 (høyre–venstre, foran–bak, fot–hode)</translation>
    </message>
    <message>
        <source>%1 (x, y, z)</source>
        <translation>%1 (x, y, z)</translation>
    </message>
    <message>
        <source>Anatomy leaves no ground for names: the drawing ends at a frame, %1 mm within the page&apos;s left and right edge.</source>
        <translation>Anatomien gir navnene ingen plass: Tegningen slutter ved en ramme, %1 mm innenfor sidens venstre og høyre kant.</translation>
    </message>
    <message>
        <source>Choose a view from farther away, or no labels.</source>
        <translation>Velg en visning lenger unna, eller ingen etiketter.</translation>
    </message>
    <message numerus="yes">
        <source>Names tell that these files are of %n bodies. Put them into one scene?</source>
        <translation>
            <numerusform>Navnene forteller at disse filene hører til %n kropp. Skal de bli én scene?</numerusform>
            <numerusform>Navnene forteller at disse filene hører til %n kropper. Skal de bli én scene?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as what they name may lie on the other side: %1.</source>
        <translation>
            <numerusform>%n etikett blir ikke spurt etter, da det den navngir kan ligge på den andre siden: %1.</numerusform>
            <numerusform>%n etiketter blir ikke spurt etter, da det de navngir kan ligge på den andre siden: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Say that names are right, or give it another name.</source>
        <translation>Si at navnene er riktige, eller gi det et annet navn.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AboutDialog</name>
    <message>
        <source>About Sline</source>
        <translation>Om Sline</translation>
    </message>
    <message>
        <source>Turns segmented anatomy into focus-and-context line illustrations. Free software under the Apache License 2.0.</source>
        <translation>Gjør segmentert anatomi til strekillustrasjoner med fokus og kontekst. Fri programvare under Apache-lisensen 2.0.</translation>
    </message>
    <message>
        <source>After Lichtenberg, Smit, Hansen and Lawonn, “Sline: Seamless Line Illustration for Interactive Biomedical Visualization” (VCBM 2016), and Lawonn, Mönch and Preim, “Streamlines for Illustrative Real-Time Rendering” (EuroVis 2013).</source>
        <translation>Etter Lichtenberg, Smit, Hansen og Lawonn, «Sline: Seamless Line Illustration for Interactive Biomedical Visualization» (VCBM 2016), og Lawonn, Mönch og Preim, «Streamlines for Illustrative Real-Time Rendering» (EuroVis 2013).</translation>
    </message>
    <message>
        <source>Qt %1 on %2
OpenGL: %3</source>
        <translation>Qt %1 på %2
OpenGL: %3</translation>
    </message>
    <message>
        <source>not started yet</source>
        <translation>ikke startet ennå</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopier</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AnatomyPalette</name>
    <message>
        <source>Anatomical colours</source>
        <translation>Anatomiske farger</translation>
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
        <translation>Slag</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>Peker på</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Vist</translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation>Ikke vist</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Endre etikettens tekst</translation>
    </message>
    <message>
        <source>Show Label</source>
        <translation>Vis etiketten</translation>
    </message>
    <message>
        <source>Hide Label</source>
        <translation>Skjul etiketten</translation>
    </message>
    <message>
        <source>Says (%1)</source>
        <translation>Tekst (%1)</translation>
    </message>
    <message>
        <source>Says (scene’s own)</source>
        <translation>Tekst (scenens)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AnnotationsPanel</name>
    <message>
        <source>Delete</source>
        <translation>Slett</translation>
    </message>
    <message>
        <source>Take this label away</source>
        <translation>Ta bort denne etiketten</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketter</translation>
    </message>
    <message>
        <source>What the label says</source>
        <translation>Hva etiketten sier</translation>
    </message>
    <message>
        <source>Kind of label</source>
        <translation>Slags etikett</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farge</translation>
    </message>
    <message>
        <source>Of the dot at its place</source>
        <translation>På prikken der den peker</translation>
    </message>
    <message>
        <source>As the &amp;Ink</source>
        <translation>Som &amp;blekket</translation>
    </message>
    <message>
        <source>Colour of a Label</source>
        <translation>Etikettens farge</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Farge …</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Låst</translation>
    </message>
    <message>
        <source>The mouse does not move it</source>
        <translation>Musen flytter den ikke</translation>
    </message>
    <message>
        <source>Lock Label</source>
        <translation>Lås etiketten</translation>
    </message>
    <message>
        <source>Unlock Label</source>
        <translation>Lås opp etiketten</translation>
    </message>
    <message>
        <source>Place by Itself</source>
        <translation>Plasser av seg selv</translation>
    </message>
    <message>
        <source>It finds its place again, after it was moved by hand</source>
        <translation>Den finner plassen sin selv igjen, etter at den ble flyttet for hånd</translation>
    </message>
    <message>
        <source>Place Label by Itself</source>
        <translation>Plasser etiketten av seg selv</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Slett etiketten</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Endre etikettens tekst</translation>
    </message>
    <message>
        <source>Kind of Label</source>
        <translation>Slags etikett</translation>
    </message>
    <message>
        <source>Choose a label</source>
        <translation>Velg en etikett</translation>
    </message>
    <message>
        <source>Delete Labels</source>
        <translation>Slett etikettene</translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushBar</name>
    <message>
        <source>Brush</source>
        <translation>Pensel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Størrelse</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Penselens radius ([ og ])</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Mykhet</translation>
    </message>
    <message>
        <source>How much weaker the brush is towards its rim</source>
        <translation>Hvor mye svakere penselen er mot kanten</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Styrke</translation>
    </message>
    <message>
        <source>How much a stroke paints in its middle</source>
        <translation>Hvor mye et strøk maler i midten</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Visk ut</translation>
    </message>
    <message>
        <source>Take away instead (Ctrl while you paint)</source>
        <translation>Ta bort i stedet (Ctrl mens du maler)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Tøm</translation>
    </message>
    <message>
        <source>Take away all that is painted on the selected</source>
        <translation>Ta bort alt som er malt på det valgte</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Ferdig</translation>
    </message>
    <message>
        <source>Put the brush away (Esc)</source>
        <translation>Legg penselen bort (Esc)</translation>
    </message>
    <message>
        <source>Clear Paint</source>
        <translation>Tøm malingen</translation>
    </message>
    <message>
        <source>Click on what you want to paint on</source>
        <translation>Klikk på det du vil male på</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n struktur</numerusform>
            <numerusform>%n strukturer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushTool</name>
    <message>
        <source>Erase on %1</source>
        <translation>Visk ut på %1</translation>
    </message>
    <message>
        <source>Paint on %1</source>
        <translation>Mal på %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ComparisonDialog</name>
    <message>
        <source>&amp;Save Sheet…</source>
        <translation>&amp;Lagre ark …</translation>
    </message>
    <message>
        <source>Compare Techniques</source>
        <translation>Sammenlign teknikker</translation>
    </message>
    <message>
        <source>Su&amp;rface:</source>
        <translation>&amp;Overflate:</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Som den er</translation>
    </message>
    <message>
        <source>With staircase</source>
        <translation>Med trappetrinn</translation>
    </message>
    <message>
        <source>With jitter</source>
        <translation>Med skjelving</translation>
    </message>
    <message>
        <source>Roughens the surface, to see which techniques bear what segmentation leaves on it</source>
        <translation>Gjør overflaten ru, for å se hvilke teknikker som tåler det segmentering etterlater på den</translation>
    </message>
    <message>
        <source>Reset &amp;Thresholds</source>
        <translation>Tilbakestill &amp;terskler</translation>
    </message>
    <message>
        <source>As PDF, SVG or PNG, with what the pictures take and draw</source>
        <translation>Som PDF, SVG eller PNG, med det bildene krever og tegner</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 trekanter</translation>
    </message>
    <message>
        <source>ms: median time to find and join the lines of a view, contours among them, once the surface is prepared.</source>
        <translation>ms: median av tiden det tar å finne og forbinde linjene i en visning, konturer medregnet, når overflaten er forberedt.</translation>
    </message>
    <message>
        <source>mm⁻¹: length of the technique&apos;s visible lines, without contours, per area that the model covers, as drawn here.</source>
        <translation>mm⁻¹: lengden av teknikkens synlige linjer, uten konturer, per areal som modellen dekker, slik det er tegnet her.</translation>
    </message>
    <message>
        <source>F: radius of the model&apos;s bounding sphere; F_c: its median radius of curvature, at most F; H, κ1: mean curvature, the stronger principal curvature; f: light from the eye.</source>
        <translation>F: radien til modellens omsluttende kule; F_c: dens mediane krumningsradius, høyst F; H, κ1: middelkrumning, den sterkeste hovedkrumningen; f: lys fra øyet.</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Lagre ark</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-tegning (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-bilde (*.png)</translation>
    </message>
    <message>
        <source>Drawing the sheet…</source>
        <translation>Arket tegnes …</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 er lagret</translation>
    </message>
    <message>
        <source>Ro&amp;w for each</source>
        <translation>&amp;Rad for hver</translation>
    </message>
    <message>
        <source>Shows what was selected one below the other, else all of it together</source>
        <translation>Viser det valgte under hverandre, ellers alt sammen</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-bilde (*.tiff)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ControlsDialog</name>
    <message>
        <source>Mouse and Keys</source>
        <translation>Mus og taster</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrer</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mus</translation>
    </message>
    <message>
        <source>List of structures</source>
        <translation>Liste over strukturer</translation>
    </message>
</context>
<context>
    <name>sline::widgets::CubeMark</name>
    <message>
        <source>Orientation cube</source>
        <translation>Orienteringskube</translation>
    </message>
    <message>
        <source>The keys A, P, L, R, S and I look from the same sides.</source>
        <translation>Tastene A, P, L, R, S og I ser fra de samme sidene.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::DrawingPanel</name>
    <message>
        <source>Drawing Styles</source>
        <translation>Tegnestiler</translation>
    </message>
    <message>
        <source>Draws the whole scene in one manner</source>
        <translation>Tegner hele scenen på én måte</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpen</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Foldet sammen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportActions</name>
    <message>
        <source>The export was stopped</source>
        <translation>Eksporten ble stoppet</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Eksporterer %1</translation>
    </message>
    <message numerus="yes">
        <source>Exporting %n files</source>
        <translation>
            <numerusform>Eksporterer %n fil</numerusform>
            <numerusform>Eksporterer %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpne</translation>
    </message>
    <message>
        <source>With the program that this system has for it</source>
        <translation>Med programmet dette systemet har for det</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Vis mappen</translation>
    </message>
    <message>
        <source>Where it was written to</source>
        <translation>Der det ble skrevet</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 er eksportert</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>%n fil er eksportert</numerusform>
            <numerusform>%n filer er eksportert</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Bildet er på utklippstavlen</translation>
    </message>
    <message>
        <source>An export is under way. Stop it and close the window?</source>
        <translation>En eksport pågår. Stoppe den og lukke vinduet?</translation>
    </message>
    <message>
        <source>Stop and Close</source>
        <translation>Stopp og lukk</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Fortsett</translation>
    </message>
    <message>
        <source>Print proof</source>
        <translation>Prøvetrykk</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportDialog</name>
    <message>
        <source>&amp;What the window shows</source>
        <translation>Det &amp;vinduet viser</translation>
    </message>
    <message>
        <source>&amp;Fill the page with what is shown</source>
        <translation>&amp;Fyll siden med det som vises</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksporter</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Eksporter %1</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Filtype</translation>
    </message>
    <message numerus="yes">
        <source>Each sa&amp;ved view, %n files</source>
        <translation>
            <numerusform>Hver &amp;lagret visning, %n fil</numerusform>
            <numerusform>Hver &amp;lagret visning, %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves the camera to or fro without turning it</source>
        <translation>Flytter kameraet fram eller tilbake uten å dreie det</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Hva</translation>
    </message>
    <message>
        <source>For this kind</source>
        <translation>For denne typen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bilde</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketter</translation>
    </message>
    <message>
        <source>At the picture&apos;s edge</source>
        <translation>Ved kanten av bildet</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Side</translation>
    </message>
    <message>
        <source>What the file will contain</source>
        <translation>Hva filen vil inneholde</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>F&amp;il</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Bla gjennom …</translation>
    </message>
    <message>
        <source>Export To</source>
        <translation>Eksporter til</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>«%1» finnes allerede. Erstatte den?</translation>
    </message>
    <message numerus="yes">
        <source>%n of the files are there already. Replace them?</source>
        <translation>
            <numerusform>%n av filene finnes allerede. Erstatte den?</numerusform>
            <numerusform>%n av filene finnes allerede. Erstatte dem?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>In the file&apos;s details</source>
        <translation>I filens opplysninger</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Språk: %1</translation>
    </message>
    <message numerus="yes">
        <source>All %n sa&amp;ved views, in one file</source>
        <translation>
            <numerusform>Den %n lag&amp;rede visningen, i én fil</numerusform>
            <numerusform>Alle %n lag&amp;rede visninger, i én fil</numerusform>
        </translation>
    </message>
    <message>
        <source>Each view has a page, a slide or a deck of its own</source>
        <translation>Hver visning har sin egen side, sitt eget lysbilde eller sin egen kortstokk</translation>
    </message>
    <message>
        <source>A file for each view, with its number and name behind the file&apos;s own</source>
        <translation>En fil for hver visning, med nummeret og navnet bak filens eget</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Forhåndsvisning</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Tegner …</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureDialog</name>
    <message>
        <source>Add</source>
        <translation>Legg til</translation>
    </message>
    <message>
        <source>Add a panel with a view</source>
        <translation>Legg til et felt med en visning</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Fjern</translation>
    </message>
    <message>
        <source>Remove the panel</source>
        <translation>Fjern feltet</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Opp</translation>
    </message>
    <message>
        <source>Move the panel up</source>
        <translation>Flytt feltet opp</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ned</translation>
    </message>
    <message>
        <source>Move the panel down</source>
        <translation>Flytt feltet ned</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Eksporter…</translation>
    </message>
    <message>
        <source>Figure of Several Panels</source>
        <translation>Figur med flere felt</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Side</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Felt</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Åpne…</translation>
    </message>
    <message>
        <source>&amp;Save Figure…</source>
        <translation>&amp;Lagre figur…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
    <message>
        <source>Another Scene…</source>
        <translation>En annen scene…</translation>
    </message>
    <message>
        <source>Open Figure</source>
        <translation>Åpne figur</translation>
    </message>
    <message>
        <source>Figures (*.json)</source>
        <translation>Figurer (*.json)</translation>
    </message>
    <message>
        <source>Add Views of Another Scene</source>
        <translation>Legg til visninger fra en annen scene</translation>
    </message>
    <message>
        <source>Scenes (*.sline)</source>
        <translation>Scener (*.sline)</translation>
    </message>
    <message>
        <source>Save Figure</source>
        <translation>Lagre figur</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>Export Figure</source>
        <translation>Eksporter figur</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-tegning (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-bilde (*.png)</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>Skriver figuren …</translation>
    </message>
    <message>
        <source>The figure has changes that are in no file.</source>
        <translation>Figuren har endringer som ikke er i noen fil.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Lagre…</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Forkast</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>As PDF, SVG, PNG or TIFF</source>
        <translation>Som PDF, SVG, PNG eller TIFF</translation>
    </message>
    <message>
        <source>The page as it was; it is being drawn anew…</source>
        <translation>Siden slik den var; den tegnes på nytt …</translation>
    </message>
    <message>
        <source>The page as it was; %1 has changed</source>
        <translation>Siden slik den var; %1 er endret</translation>
    </message>
    <message>
        <source>The page as it was before the last change</source>
        <translation>Siden slik den var før den siste endringen</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-bilde (*.tiff)</translation>
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
        <translation>Annen</translation>
    </message>
    <message>
        <source>&amp;Width for journals</source>
        <translation>&amp;Bredde for tidsskrifter</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>As panels need</source>
        <translation>Som feltene trenger</translation>
    </message>
    <message>
        <source>Colum&amp;ns</source>
        <translation>&amp;Kolonner</translation>
    </message>
    <message>
        <source>&amp;Letters of panels</source>
        <translation>Bokstaver på &amp;felt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Their size</source>
        <translation>Størrelsen deres</translation>
    </message>
    <message>
        <source>Size of la&amp;bels</source>
        <translation>Størrelse på &amp;etiketter</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>Ko&amp;nturer</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>Te&amp;gnforklaring</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle strukturer</translation>
    </message>
    <message>
        <source>What labels point at</source>
        <translation>Det etiketter peker på</translation>
    </message>
    <message>
        <source>What is in focus</source>
        <translation>Det som er i fokus</translation>
    </message>
    <message>
        <source>Per&amp;spective</source>
        <translation>&amp;Perspektiv</translation>
    </message>
    <message>
        <source>As views were saved</source>
        <translation>Som visningene ble lagret</translation>
    </message>
    <message>
        <source>T&amp;hin lines</source>
        <translation>&amp;Tynne linjer</translation>
    </message>
    <message>
        <source>Drawn wide enough to print</source>
        <translation>Tegnes bredt nok til trykk</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Avvises</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Beholdes</translation>
    </message>
    <message>
        <source>Labels in all panels</source>
        <translation>Etiketter i alle felt</translation>
    </message>
    <message>
        <source>Scale bars in all panels</source>
        <translation>Målestokk i alle felt</translation>
    </message>
    <message>
        <source>R and L in all panels</source>
        <translation>R og L i alle felt</translation>
    </message>
    <message>
        <source>Black and white</source>
        <translation>Svart-hvitt</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Forfra</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Bakfra</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Fra venstre</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Fra høyre</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Ovenfra</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Nedenfra</translation>
    </message>
    <message>
        <source>Part of %1</source>
        <translation>Del av %1</translation>
    </message>
    <message>
        <source>On its panel</source>
        <translation>På feltet sitt</translation>
    </message>
    <message>
        <source>Lines from its frame</source>
        <translation>Linjer fra rammen</translation>
    </message>
    <message>
        <source>As its view has it</source>
        <translation>Som visningen har det</translation>
    </message>
    <message>
        <source>Fitted to the panel</source>
        <translation>Tilpasset feltet</translation>
    </message>
    <message>
        <source>Like %1</source>
        <translation>Som %1</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>K&amp;amera</translation>
    </message>
    <message>
        <source>As its panel</source>
        <translation>Som feltet sitt</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visning</translation>
    </message>
    <message>
        <source>Spans columns</source>
        <translation>Over kolonner</translation>
    </message>
    <message>
        <source>Spans rows</source>
        <translation>Over rader</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketter</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Målestokk</translation>
    </message>
    <message>
        <source>A panel may have a choice of its own</source>
        <translation>Et panel kan ha det annerledes</translation>
    </message>
    <message>
        <source>If not as in the other panels</source>
        <translation>Hvis ikke som i de andre panelene</translation>
    </message>
    <message>
        <source>One column of a journal, one and a half, or two</source>
        <translation>Én spalte i et tidsskrift, halvannen eller to</translation>
    </message>
    <message>
        <source>For pages that no journal prescribes</source>
        <translation>For sider som ingen tidsskrifter foreskriver</translation>
    </message>
    <message>
        <source>Without it panels are 4 by 3 and the legend has its room</source>
        <translation>Uten den er panelene 4 ganger 3, og forklaringen har sin plass</translation>
    </message>
    <message>
        <source>Into how many columns the page is divided; panels fill it by rows</source>
        <translation>Hvor mange spalter siden er delt i; paneler fyller den rad for rad</translation>
    </message>
    <message>
        <source>Bold, at the upper left of each panel</source>
        <translation>Fet, øverst til venstre i hvert panel</translation>
    </message>
    <message>
        <source>How large the letters of panels are</source>
        <translation>Hvor store bokstavene på panelene er</translation>
    </message>
    <message>
        <source>How wide contours are, the same in all panels</source>
        <translation>Hvor brede konturer er, like i alle paneler</translation>
    </message>
    <message>
        <source>One legend for all panels, at the foot of the page</source>
        <translation>Én forklaring for alle paneler, nederst på siden</translation>
    </message>
    <message>
        <source>Without perspective a scale bar is true everywhere</source>
        <translation>Uten perspektiv stemmer en målestokk overalt</translation>
    </message>
    <message>
        <source>And the other sides of the body</source>
        <translation>Og de andre sidene av kroppen</translation>
    </message>
    <message>
        <source>Ink alone, without tones and colours</source>
        <translation>Bare blekk, uten toner og farger</translation>
    </message>
    <message>
        <source>A saved view of the scene, or a side of the body</source>
        <translation>En lagret visning av scenen eller en side av kroppen</translation>
    </message>
    <message>
        <source>Like another panel: of the same direction and scale, to be compared</source>
        <translation>Som et annet panel: med samme retning og målestokk, til sammenligning</translation>
    </message>
    <message>
        <source>The enlarged part lies on the panel of which it is a part</source>
        <translation>Den forstørrede delen ligger på panelet den er en del av</translation>
    </message>
    <message>
        <source>From the corners of the frame to those of the enlarged part</source>
        <translation>Fra hjørnene av rammen til hjørnene av den forstørrede delen</translation>
    </message>
    <message>
        <source>How many columns of the page the panel is wide</source>
        <translation>Hvor mange spalter av siden panelet er bredt</translation>
    </message>
    <message>
        <source>How many rows of the page the panel is high</source>
        <translation>Hvor mange rader av siden panelet er høyt</translation>
    </message>
    <message>
        <source>How far panels are apart</source>
        <translation>Hvor langt feltene står fra hverandre</translation>
    </message>
    <message>
        <source>So that sizes compare: one scale bar is true for all panels; enlarged parts stay enlarged</source>
        <translation>Slik at størrelser kan sammenlignes: én målestokk gjelder for alle felt; forstørrede deler forblir forstørret</translation>
    </message>
    <message>
        <source>Of labels, scale bars and the legend, as in de, la or de+la; empty: the scene&apos;s own</source>
        <translation>For etiketter, målestokker og tegnforklaring, som de, la eller de+la; tomt: scenens eget</translation>
    </message>
    <message>
        <source>A figure with smaller ones is refused</source>
        <translation>En figur med mindre avvises</translation>
    </message>
    <message>
        <source>What thin lines are measured by</source>
        <translation>Det tynne linjer måles etter</translation>
    </message>
    <message>
        <source>Scale bars and the legend are a fifth smaller</source>
        <translation>Målestokker og tegnforklaring er en femdel mindre</translation>
    </message>
    <message>
        <source>What becomes of lines that are too thin to print; hatching stays</source>
        <translation>Hva som skjer med linjer som er for tynne til å trykkes; skravering blir stående</translation>
    </message>
    <message>
        <source>Moved aside to the middle of what this panel shows</source>
        <translation>Flyttet til siden, til midten av det feltet viser</translation>
    </message>
    <message>
        <source>In place of the next one; a blank for none</source>
        <translation>I stedet for den neste; et mellomrom for ingen</translation>
    </message>
    <message>
        <source>Between panels</source>
        <translation>Mellom felt</translation>
    </message>
    <message>
        <source>Smallest letters</source>
        <translation>Minste skrift</translation>
    </message>
    <message>
        <source>Thinnest lines</source>
        <translation>Tynneste linjer</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>Same scale in all panels</source>
        <translation>Samme målestokk i alle felt</translation>
    </message>
    <message>
        <source>On its own middle</source>
        <translation>På sin egen midte</translation>
    </message>
    <message>
        <source>R and L</source>
        <translation>R og L</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Bokstav</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigurePreview</name>
    <message>
        <source>The figure</source>
        <translation>Figuren</translation>
    </message>
    <message>
        <source>Drag a rectangle in a panel to show that part enlarged</source>
        <translation>Dra et rektangel i et felt for å vise den delen forstørret</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Tegner…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureWriting</name>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>Figuren skrives …</translation>
    </message>
    <message>
        <source>Stop writing; a file that was there before stays as it is</source>
        <translation>Slutt å skrive; en fil som fantes fra før, forblir som den er</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Lagret %1</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Stoppet; ingenting ble skrevet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FileActions</name>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Lagrer %1 …</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 er lagret</translation>
    </message>
    <message>
        <source>it is no longer there</source>
        <translation>den er ikke der lenger</translation>
    </message>
    <message>
        <source>Open it from where it is now</source>
        <translation>Åpne den der den er nå</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Lagre en kopi</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Lagre som</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (skrivebeskyttet)</translation>
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
        <translation>%1 er åpnet skrivebeskyttet</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Tøm listen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FilePager</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 av %3)</translation>
    </message>
    <message>
        <source>Preview of what comes before</source>
        <translation>Forhåndsvisning av det forrige</translation>
    </message>
    <message>
        <source>Preview of what comes next</source>
        <translation>Forhåndsvisning av det neste</translation>
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
        <translation>Fokus fra denne visningen</translation>
    </message>
    <message>
        <source>Focus all round</source>
        <translation>Fokus rundt hele</translation>
    </message>
    <message>
        <source>nothing is left to focus on</source>
        <translation>det er ingenting igjen å fokusere på</translation>
    </message>
    <message>
        <source>Select something that no section takes away</source>
        <translation>Velg noe som ikke tas bort av et snitt</translation>
    </message>
    <message>
        <source>Role in the context</source>
        <translation>Rolle i konteksten</translation>
    </message>
    <message>
        <source>Hidden structures in the context</source>
        <translation>Skjulte strukturer i konteksten</translation>
    </message>
    <message>
        <source>Context %1 %</source>
        <translation>Kontekst %1 %</translation>
    </message>
    <message>
        <source>Opening look</source>
        <translation>Utseende ved åpning</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plansje</translation>
    </message>
    <message>
        <source>set by hand since</source>
        <translation>siden satt for hånd</translation>
    </message>
    <message>
        <source>Back to the focus</source>
        <translation>Tilbake til fokus</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusPanel</name>
    <message>
        <source>As you said</source>
        <translation>Som du sa</translation>
    </message>
    <message>
        <source>Focus on Selection</source>
        <translation>Fokus på utvalget</translation>
    </message>
    <message>
        <source>These in detail, everything else by what it is to them</source>
        <translation>Disse i detalj, alt annet etter hva det er for dem</translation>
    </message>
    <message>
        <source>How much context</source>
        <translation>Hvor mye kontekst</translation>
    </message>
    <message>
        <source>Focus alone</source>
        <translation>Bare fokus</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>All Round</source>
        <translation>Rundt hele</translation>
    </message>
    <message>
        <source>Nothing hides the focus from whatever side it is seen</source>
        <translation>Ingenting dekker fokus, uansett hvilken side den ses fra</translation>
    </message>
    <message>
        <source>This View</source>
        <translation>Denne visningen</translation>
    </message>
    <message>
        <source>Nothing hides the focus as it is seen now; what lies behind it may be solid</source>
        <translation>Ingenting dekker fokus slik den ses nå; det som ligger bak, kan være dekkende</translation>
    </message>
    <message>
        <source>What each structure is to the focus</source>
        <translation>Hva hver struktur er for fokus</translation>
    </message>
    <message>
        <source>Treat as</source>
        <translation>Behandle som</translation>
    </message>
    <message>
        <source>&amp;Treat as</source>
        <translation>&amp;Behandle som</translation>
    </message>
    <message>
        <source>Nothing in focus</source>
        <translation>Ingenting i fokus</translation>
    </message>
    <message numerus="yes">
        <source>%n structures in focus</source>
        <translation>
            <numerusform>%n struktur i fokus</numerusform>
            <numerusform>%n strukturer i fokus</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking at what surrounds it…</source>
        <translation>Ser på det som er rundt …</translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Velg en struktur i listen eller i bildet.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Also what was hidden</source>
        <translation>Også det som var skjult</translation>
    </message>
    <message numerus="yes">
        <source>Also %n hidden structures</source>
        <translation>
            <numerusform>Også %n skjult struktur</numerusform>
            <numerusform>Også %n skjulte strukturer</numerusform>
        </translation>
    </message>
    <message>
        <source>Set by hand since; the focus leaves it so</source>
        <translation>Siden satt for hånd; fokus lar det være slik</translation>
    </message>
    <message>
        <source>%1 – by hand</source>
        <translation>%1 – for hånd</translation>
    </message>
    <message>
        <source>Draws them as the focus would; only those chosen in the list, if any</source>
        <translation>Tegner dem slik fokus ville gjort; bare de valgte i listen, hvis noen er valgt</translation>
    </message>
    <message numerus="yes">
        <source>%n by Hand: Back to the Focus</source>
        <translation>
            <numerusform>%n for hånd: tilbake til fokus</numerusform>
            <numerusform>%n for hånd: tilbake til fokus</numerusform>
        </translation>
    </message>
    <message>
        <source>Nearness to a place</source>
        <translation>Nærhet til et sted</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaCurve</name>
    <message>
        <source>Curve of Γ</source>
        <translation>Kurve for Γ</translation>
    </message>
    <message>
        <source>What is added to Γ, from left to right along the value. Drag a point; a double click or Insert adds one, Delete takes one away. Arrow keys move the chosen point, Space chooses the next</source>
        <translation>Hva som legges til Γ, fra venstre mot høyre langs verdien. Dra et punkt; et dobbeltklikk eller Insert legger til et, Delete tar et bort. Piltastene flytter det valgte punktet, mellomrom velger det neste</translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 at %4</source>
        <translation>Punkt %1 av %2: %3 ved %4</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaMapEditor</name>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ over flaten</translation>
    </message>
    <message>
        <source>Lets Γ vary from place to place on a structure</source>
        <translation>Lar Γ variere fra sted til sted på en struktur</translation>
    </message>
    <message>
        <source>The same everywhere</source>
        <translation>Likt overalt</translation>
    </message>
    <message>
        <source>By cavities</source>
        <translation>Etter hulrom</translation>
    </message>
    <message>
        <source>By curvature</source>
        <translation>Etter krumning</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Etter avstand</translation>
    </message>
    <message>
        <source>Several</source>
        <translation>Flere</translation>
    </message>
    <message>
        <source>Distance from</source>
        <translation>Avstand fra</translation>
    </message>
    <message>
        <source>The structure or group from which distances are measured</source>
        <translation>Strukturen eller gruppen som avstander måles fra</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Ingenting</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elementer</numerusform>
        </translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Mal …</translation>
    </message>
    <message>
        <source>By painting</source>
        <translation>Etter maling</translation>
    </message>
    <message>
        <source>Cavities: how much of its own sky the surface hides, 0 to 1. Curvature: 1 on a ball, negative in hollows. Distance: millimetres from another structure. Painting: what you paint in the picture, 0 to 1</source>
        <translation>Hulrom: hvor mye av sin egen himmel flaten skjuler, 0 til 1. Krumning: 1 på en kule, negativ i fordypninger. Avstand: millimeter fra en annen struktur. Maling: det du maler i bildet, 0 til 1</translation>
    </message>
    <message>
        <source>Paint in the picture with a brush</source>
        <translation>Mal i bildet med en pensel</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaPanel</name>
    <message>
        <source>Nothing selected</source>
        <translation>Ingenting valgt</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elementer</numerusform>
        </translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Velg en struktur i listen eller i bildet.</translation>
    </message>
    <message>
        <source>Gamma, from silhouette to surface</source>
        <translation>Gamma, fra silhuett til overflate</translation>
    </message>
    <message>
        <source>Gamma as a number</source>
        <translation>Gamma som tall</translation>
    </message>
    <message>
        <source>Γ  </source>
        <translation>Γ  </translation>
    </message>
    <message>
        <source>Inherit</source>
        <translation>Arv</translation>
    </message>
    <message>
        <source>Take Γ from the group above again</source>
        <translation>Ta Γ fra gruppen over igjen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpen</translation>
    </message>
    <message>
        <source>What is behind shows through</source>
        <translation>Det som er bak, skinner gjennom</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Dekkende</translation>
    </message>
    <message>
        <source>Hides what is behind</source>
        <translation>Dekker det som er bak</translation>
    </message>
    <message>
        <source>Veil</source>
        <translation>Slør</translation>
    </message>
    <message>
        <source>What is behind shows faintly, as through tracing paper</source>
        <translation>Det som er bak, skimtes som gjennom kalkerpapir</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tone</translation>
    </message>
    <message>
        <source>A thin wash of the structure&apos;s colour; what is behind shows through</source>
        <translation>Et tynt lag av strukturens farge; det som er bak, skinner gjennom</translation>
    </message>
    <message>
        <source>Where only lines are drawn</source>
        <translation>Der bare linjer er tegnet</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Arv Γ</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Fylling</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Forvalg</translation>
    </message>
    <message>
        <source>A number that is typed is for all that is selected</source>
        <translation>Et tall som skrives inn, gjelder alt som er valgt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hjelp</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Side</translation>
    </message>
    <message>
        <source>Search in help</source>
        <translation>Søk i hjelpen</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Innhold</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tilbake</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Fram</translation>
    </message>
    <message>
        <source>Open in the Browser?</source>
        <translation>Åpne i nettleseren?</translation>
    </message>
    <message>
        <source>This link leads out of the program, to
%1</source>
        <translation>Denne lenken fører ut av programmet, til
%1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportActions</name>
    <message>
        <source>The Size Is Right</source>
        <translation>Størrelsen stemmer</translation>
    </message>
    <message>
        <source>The size is right</source>
        <translation>Størrelsen stemmer</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>Bruk %1 som enhet</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read as %1, unlike alone: so they go with the open scene</source>
        <translation>
            <numerusform>%n struktur ble lest som %1, annerledes enn alene: slik passer den til den åpne scenen</numerusform>
            <numerusform>%n strukturer ble lest som %1, annerledes enn alene: slik passer de til den åpne scenen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturer</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Utelatt</translation>
    </message>
    <message>
        <source>Filter by name or file</source>
        <translation>Filtrer etter navn eller fil</translation>
    </message>
    <message>
        <source>What is left out or mended</source>
        <translation>Hva som utelates eller repareres</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>What happened, and what to do</source>
        <translation>Hva som skjedde, og hva som kan gjøres</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Framdrift i lesingen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Opens what is listed as a scene of its own</source>
        <translation>Åpner det som er listet, som en egen scene</translation>
    </message>
    <message>
        <source>Add to Scene</source>
        <translation>Legg til i scenen</translation>
    </message>
    <message>
        <source>Puts what is listed below the structures of the open scene</source>
        <translation>Legger det som er listet, under strukturene i den åpne scenen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leser …</translation>
    </message>
    <message>
        <source>Left out or mended</source>
        <translation>Utelatt eller reparert</translation>
    </message>
    <message>
        <source>Left out or mended (%1)</source>
        <translation>Utelatt eller reparert (%1)</translation>
    </message>
    <message>
        <source>Nothing can be imported</source>
        <translation>Det er ingenting å importere</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Opptak</translation>
    </message>
    <message>
        <source>The Size Is Right</source>
        <translation>Størrelsen stemmer</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>Bruk %1 som enhet</translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either</source>
        <translation>Ord i valgfri rekkefølge; «%1» eller et komma mellom dem finner begge</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDraft</name>
    <message>
        <source>LPS – left, posterior, superior</source>
        <translation>LPS – venstre, bak, øvre</translation>
    </message>
    <message>
        <source>RAS – right, anterior, superior</source>
        <translation>RAS – høyre, foran, øvre</translation>
    </message>
    <message>
        <source>As in the file, unturned</source>
        <translation>Som i filen, ikke dreid</translation>
    </message>
    <message>
        <source>mm – millimetres</source>
        <translation>mm – millimeter</translation>
    </message>
    <message>
        <source>cm – centimetres</source>
        <translation>cm – centimeter</translation>
    </message>
    <message>
        <source>m – metres</source>
        <translation>m – meter</translation>
    </message>
    <message>
        <source>in – inches</source>
        <translation>in – tommer</translation>
    </message>
    <message>
        <source>µm – micrometres</source>
        <translation>µm – mikrometer</translation>
    </message>
    <message>
        <source>Å – ångström</source>
        <translation>Å – ångström</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Av</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n trinn</numerusform>
            <numerusform>%n trinn</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Behold alle</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisk</translation>
    </message>
    <message>
        <source>off</source>
        <translation>av</translation>
    </message>
    <message>
        <source>within %1 mm</source>
        <translation>innenfor %1 mm</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nei</translation>
    </message>
    <message>
        <source>as the scene file has it</source>
        <translation>slik scenefilen har det</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>; og %n til</numerusform>
            <numerusform>; og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>ukjent</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>som i filen</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n struktur</numerusform>
            <numerusform>%n strukturer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n groups</source>
        <translation>
            <numerusform>%n gruppe</numerusform>
            <numerusform>%n grupper</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 trekanter</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n hoppet over</numerusform>
            <numerusform>%n hoppet over</numerusform>
        </translation>
    </message>
    <message>
        <source>Everything together is %1 mm large</source>
        <translation>Alt sammen er %1 mm stort</translation>
    </message>
    <message>
        <source>%1. If the files are in %2, it is %3 mm.</source>
        <translation>%1. Hvis filene er i %2, er det %3 mm.</translation>
    </message>
    <message>
        <source>%1, which is small for anatomy.</source>
        <translation>%1, noe som er lite for anatomi.</translation>
    </message>
    <message>
        <source>%1, which is large for anatomy.</source>
        <translation>%1, noe som er stort for anatomi.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures lie on the other side than their names say: %1.</source>
        <translation>
            <numerusform>%n struktur ligger på den andre siden enn navnet sier: %1.</numerusform>
            <numerusform>%n strukturer ligger på den andre siden enn navnene sier: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles, %4</source>
        <translation>%1: %2, %3 trekanter, %4</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, fra %2</translation>
    </message>
    <message>
        <source>From a scene file: it keeps its place, size and triangles.</source>
        <translation>Fra en scenefil: den beholder plass, størrelse og trekanter.</translation>
    </message>
    <message>
        <source>Frame: %1</source>
        <translation>Aksesystem: %1</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>Enhet: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n faces mended</source>
        <translation>
            <numerusform>%n flate reparert</numerusform>
            <numerusform>%n flater reparert</numerusform>
        </translation>
    </message>
    <message>
        <source>Its name says the other side than it lies on.</source>
        <translation>Navnet sier den andre siden enn den ligger på.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisk</translation>
    </message>
    <message>
        <source>LAS – left, anterior, superior (mirrors)</source>
        <translation>LAS – venstre, anterior, superior (speiler)</translation>
    </message>
    <message>
        <source>RPS – right, posterior, superior (mirrors)</source>
        <translation>RPS – høyre, posterior, superior (speiler)</translation>
    </message>
    <message numerus="yes">
        <source>Left and right look swapped: all %n structures with a side in their names lie on the other side (%1).</source>
        <translation>
            <numerusform>Venstre og høyre ser ut til å være byttet om: %n struktur med en side i navnet ligger på den andre siden (%1).</numerusform>
            <numerusform>Venstre og høyre ser ut til å være byttet om: alle %n strukturer med en side i navnet ligger på den andre siden (%1).</numerusform>
        </translation>
    </message>
    <message>
        <source>Front and back are right: if the files are mirrored, choose %1.</source>
        <translation>Foran og bak stemmer: er filene speilvendt, velg %1.</translation>
    </message>
    <message>
        <source>Choose %1.</source>
        <translation>Velg %1.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::IntensityRange</name>
    <message>
        <source>Intensities</source>
        <translation>Intensiteter</translation>
    </message>
    <message>
        <source>How often each intensity occurs. Drag the bounds; on the keyboard the arrows move the lower one, with Shift the upper one</source>
        <translation>Hvor ofte hver intensitet forekommer. Dra grensene; på tastaturet flytter pilene den nedre, med Skift den øvre</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelActions</name>
    <message>
        <source>Click on two places to measure between them; Esc ends this</source>
        <translation>Klikk på to steder for å måle mellom dem; Esc avslutter</translation>
    </message>
    <message>
        <source>Click on a place to mark it; Esc ends this</source>
        <translation>Klikk på et sted for å merke det; Esc avslutter</translation>
    </message>
    <message>
        <source>Click on a structure and type; Shift+Return begins a line, Esc ends this</source>
        <translation>Klikk på en struktur og skriv; Shift+Enter begynner en linje, Esc avslutter</translation>
    </message>
    <message>
        <source>Click on a structure and type; Esc ends this</source>
        <translation>Klikk på en struktur og skriv; Esc avslutter</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketter</translation>
    </message>
    <message numerus="yes">
        <source>Add %n labels</source>
        <translation>
            <numerusform>Legg til %n etikett</numerusform>
            <numerusform>Legg til %n etiketter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels added</source>
        <translation>
            <numerusform>%n etikett lagt til</numerusform>
            <numerusform>%n etiketter lagt til</numerusform>
        </translation>
    </message>
    <message>
        <source>What is selected has labels already, or is not in the picture</source>
        <translation>Det valgte har etiketter allerede, eller er ikke i bildet</translation>
    </message>
    <message>
        <source>Nothing is there: click on a structure</source>
        <translation>Der er det ingenting: klikk på en struktur</translation>
    </message>
    <message>
        <source>Label added; %1</source>
        <translation>Etikett lagt til; %1</translation>
    </message>
    <message>
        <source>shown in %1 of %2 saved views: the panel Labels says in which</source>
        <translation>vises i %1 av %2 lagrede visninger: panelet «Etiketter» sier i hvilke</translation>
    </message>
    <message numerus="yes">
        <source>%n have no room in this picture: the panel Labels says which</source>
        <translation>
            <numerusform>%n har ikke plass i dette bildet: panelet «Etiketter» sier hvilken</numerusform>
            <numerusform>%n har ikke plass i dette bildet: panelet «Etiketter» sier hvilke</numerusform>
        </translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Legg til avstand</translation>
    </message>
    <message>
        <source>The shortest distance between the two selected structures was added; with another selection you choose two places</source>
        <translation>Den korteste avstanden mellom de to valgte strukturene er lagt til; med et annet utvalg velger du to steder</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelEditor</name>
    <message>
        <source>What the label says</source>
        <translation>Hva etiketten sier</translation>
    </message>
    <message>
        <source>Return takes it over, Shift+Return begins a line, Esc forgets it</source>
        <translation>Enter tar det i bruk, Shift+Enter begynner en linje, Esc forkaster det</translation>
    </message>
    <message>
        <source>Return takes it over, Esc forgets it</source>
        <translation>Enter tar det i bruk, Esc forkaster det</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelField</name>
    <message>
        <source>**bold** (%1), *italic* (%2); lines that begin with “- ” are a list</source>
        <translation>**fet** (%1), *kursiv* (%2); linjer som begynner med «- », blir en liste</translation>
    </message>
    <message>
        <source>In presentations and on students&apos; pages [ureter](#structure=left ureter) lights that structure up, and [from behind](#view=2) goes to a view</source>
        <translation>I presentasjoner og på sider for studenter løfter [urinleder](#structure=venstre urinleder) fram den strukturen, og [bakfra](#view=2) går til en visning</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelTool</name>
    <message>
        <source>Move Label</source>
        <translation>Flytt etiketten</translation>
    </message>
    <message>
        <source>Move What a Label Points At</source>
        <translation>Flytt det etiketten peker på</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelViews</name>
    <message>
        <source>Views that show it</source>
        <translation>Visninger som viser den</translation>
    </message>
    <message>
        <source>Which of the saved views show it</source>
        <translation>Hvilke av de lagrede visningene som viser den</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Visninger</translation>
    </message>
    <message>
        <source>A tick for each saved view that shows what is chosen in the list</source>
        <translation>En hake for hver lagret visning som viser det som er valgt i listen</translation>
    </message>
    <message>
        <source>In all views</source>
        <translation>I alle visninger</translation>
    </message>
    <message>
        <source>Only in %1</source>
        <translation>Bare i %1</translation>
    </message>
    <message>
        <source>In different views</source>
        <translation>I forskjellige visninger</translation>
    </message>
    <message>
        <source>In no view</source>
        <translation>Ikke i noen visning</translation>
    </message>
    <message numerus="yes">
        <source>In %n views</source>
        <translation>
            <numerusform>I %n visning</numerusform>
            <numerusform>I %n visninger</numerusform>
        </translation>
    </message>
    <message>
        <source>Views of a Label</source>
        <translation>Etikettens visninger</translation>
    </message>
    <message>
        <source>%1 (some of them)</source>
        <comment>a saved view that shows some of the labels</comment>
        <translation>%1 (noen av dem)</translation>
    </message>
    <message>
        <source>In All Views</source>
        <translation>I alle visninger</translation>
    </message>
    <message>
        <source>In No View</source>
        <translation>Ikke i noen visning</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LongestText</name>
    <message numerus="yes">
        <source>At most %n characters have room here</source>
        <translation>
            <numerusform>Her er det plass til høyst %n tegn</numerusform>
            <numerusform>Her er det plass til høyst %n tegn</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::MainWindow</name>
    <message>
        <source>Structures: %1   Triangles: %2</source>
        <translation>Strukturer: %1   Trekanter: %2</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturer</translation>
    </message>
    <message>
        <source>Line Style</source>
        <translation>Linjestil</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historikk</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Som åpnet</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Framdrift</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Åpner %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Angre</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gjør om</translation>
    </message>
    <message>
        <source>Turning around this place on %1</source>
        <translation>Dreier rundt dette stedet på %1</translation>
    </message>
    <message>
        <source>Focus and Context</source>
        <translation>Fokus og kontekst</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Structures: %1   Triangles: %2 (refined)</source>
        <translation>Strukturer: %1   Trekanter: %2 (forfinet)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ManagePresetsDialog</name>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Gi nytt navn</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Slett</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Forvalg</translation>
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
        <translation>Lukk meldingen</translation>
    </message>
    <message>
        <source>Opened, with remarks</source>
        <translation>Åpnet, med merknader</translation>
    </message>
    <message numerus="yes">
        <source>Show all %n</source>
        <translation>
            <numerusform>Vis %n</numerusform>
            <numerusform>Vis alle %n</numerusform>
        </translation>
    </message>
    <message>
        <source>What was left out or mended</source>
        <translation>Hva som ble utelatt eller reparert</translation>
    </message>
</context>
<context>
    <name>sline::widgets::MorePanel</name>
    <message>
        <source>More</source>
        <translation>Mer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Åpen</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Foldet sammen</translation>
    </message>
    <message>
        <source>Lines, hatching, opacity and colours</source>
        <translation>Linjer, skravering, dekkevne og farger</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearRow</name>
    <message>
        <source>By Nearness</source>
        <translation>Etter nærhet</translation>
    </message>
    <message>
        <source>Near a Place</source>
        <translation>Nær et sted</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Det valgte skyggelagt, alt annet mindre detaljert jo lenger unna det er</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Klikk i bildet for å sette stedet, og dra det; med Shift i dybden</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Rekkevidde</translation>
    </message>
    <message>
        <source>From what distance on there are only silhouettes</source>
        <translation>Fra hvilken avstand det bare er silhuetter</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearTool</name>
    <message>
        <source>Focus by Nearness</source>
        <translation>Fokus etter nærhet</translation>
    </message>
    <message>
        <source>Reach of Nearness</source>
        <translation>Nærhetens rekkevidde</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nærhet til et sted</translation>
    </message>
    <message>
        <source>Move the Place</source>
        <translation>Flytt stedet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NumberLimits</name>
    <message>
        <source>Numbers from %1 to %2 can be set here</source>
        <translation>Her kan tall fra %1 til %2 stilles inn</translation>
    </message>
</context>
<context>
    <name>sline::widgets::OptionsPanel</name>
    <message>
        <source>&amp;Mend faces</source>
        <translation>Rep&amp;arer flater</translation>
    </message>
    <message>
        <source>Lay molecules &amp;over each other</source>
        <translation>Legg molekyler &amp;over hverandre</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Som funnet</translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Behold alle</translation>
    </message>
    <message>
        <source>As few triangles as can be with no part of a surface moved by more than this</source>
        <translation>Så få trekanter som mulig uten at noen del av en overflate flyttes mer enn dette</translation>
    </message>
    <message>
        <source>Leaves out faces without area or given twice, and turns those that look inwards</source>
        <translation>Utelater flater uten areal eller som er gitt to ganger, og snur dem som vender innover</translation>
    </message>
    <message>
        <source>Coor&amp;dinates</source>
        <translation>Koor&amp;dinater</translation>
    </message>
    <message>
        <source>&amp;Length of a unit</source>
        <translation>&amp;Lengden av en enhet</translation>
    </message>
    <message>
        <source>Fewer t&amp;riangles, within</source>
        <translation>Færre t&amp;rekanter, innenfor</translation>
    </message>
    <message>
        <source>S&amp;moothing</source>
        <translation>&amp;Glatting</translation>
    </message>
    <message>
        <source>Automatic: takes away the steps of label maps, and refines what is too coarse to draw; steps: so much everywhere</source>
        <translation>Automatisk: tar bort trinnene fra etikettkart, og forfiner det som er for grovt til å tegnes; trinn: like mye overalt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Kee&amp;p names</source>
        <translation>Behold na&amp;vn</translation>
    </message>
    <message>
        <source>Names of files, folders and what is in them stay whole; else words that are no anatomy are left out, as they may be a person&apos;s name</source>
        <translation>Navn på filer, mapper og det som er i dem, forblir hele; ellers utelates ord som ikke hører til anatomien, for de kan være navnet på en person</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PagePanel</name>
    <message>
        <source>T&amp;urn</source>
        <translation>&amp;Snu</translation>
    </message>
    <message>
        <source>Reso&amp;lution</source>
        <translation>Opp&amp;løsning</translation>
    </message>
    <message>
        <source>Custom size</source>
        <translation>Egen størrelse</translation>
    </message>
    <message>
        <source>Upright or lying: width and height change places</source>
        <translation>Stående eller liggende: bredde og høyde bytter plass</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredde</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Høyde</translation>
    </message>
    <message>
        <source>Unit of width and height</source>
        <translation>Enhet for bredde og høyde</translation>
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
        <translation>&amp;Papir</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Størrelse</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureLabels</name>
    <message>
        <source>Add Callout</source>
        <translation>Legg til forklaring</translation>
    </message>
    <message>
        <source>Add Pin</source>
        <translation>Legg til nål</translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Legg til avstand</translation>
    </message>
    <message>
        <source>Add Label</source>
        <translation>Legg til etikett</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Endre etikettens tekst</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Slett etiketten</translation>
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
        <translation>%1 ved %2 % størrelse</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureMenu</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 og %n til</numerusform>
            <numerusform>%1 og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>Section &amp;Here</source>
        <translation>Snitt &amp;her</translation>
    </message>
    <message>
        <source>Section Here, of &amp;This Alone</source>
        <translation>Snitt her, bare av &amp;dette</translation>
    </message>
    <message>
        <source>Turn &amp;Around This Place</source>
        <translation>D&amp;rei rundt dette stedet</translation>
    </message>
    <message>
        <source>Select Here</source>
        <translation>Velg her</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureScreen</name>
    <message>
        <source>none, as the processor draws</source>
        <translation>ingen, siden prosessoren tegner</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PlanTree</name>
    <message>
        <source>What would be imported</source>
        <translation>Hva som ville bli importert</translation>
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
        <translation>Trekanter</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Størrelse, mm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Aksesystem</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhet</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glatting</translation>
    </message>
    <message>
        <source>Fewer triangles</source>
        <translation>Færre trekanter</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PocketsPanel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n residues at its wall: %1</source>
        <translation>
            <numerusform>%n rest langs veggen: %1</numerusform>
            <numerusform>%n rester langs veggen: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Lomme</translation>
    </message>
    <message>
        <source>Volume Å³</source>
        <translation>Volum Å³</translation>
    </message>
    <message>
        <source>Mouth Å²</source>
        <translation>Munning Å²</translation>
    </message>
    <message>
        <source>Burial</source>
        <translation>Innesluttet</translation>
    </message>
    <message>
        <source>The room that the small probe can fill</source>
        <translation>Rommet som den lille kulen kan fylle</translation>
    </message>
    <message>
        <source>The surface across which the pocket is open; 0: it is closed</source>
        <translation>Flaten som lommen er åpen over; 0: den er lukket</translation>
    </message>
    <message>
        <source>The share of directions in which atoms lie within 10 Å</source>
        <translation>Andelen retninger der atomer ligger innenfor 10 Å</translation>
    </message>
    <message>
        <source>Its number, and what lies in it</source>
        <translation>Nummeret og hva som ligger i den</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Pockets</source>
        <translation>Lommer</translation>
    </message>
    <message>
        <source>Click a pocket to put it in focus, with what lies in it</source>
        <translation>Klikk på en lomme for å sette den i fokus, med det som ligger i den</translation>
    </message>
    <message>
        <source>Radius of the ball that goes into pockets; water has 1.4 Å</source>
        <translation>Radius til kulen som går inn i lommer; vann har 1,4 Å</translation>
    </message>
    <message>
        <source>Radius of the ball that stays out: with a larger one, shallower and wider pockets count</source>
        <translation>Radius til kulen som blir utenfor: med en større teller også grunnere og videre lommer</translation>
    </message>
    <message>
        <source> Å³</source>
        <translation> Å³</translation>
    </message>
    <message>
        <source>Smaller pockets are left out</source>
        <translation>Mindre lommer utelates</translation>
    </message>
    <message>
        <source>&amp;Probe radius</source>
        <translation>&amp;Kuleradius</translation>
    </message>
    <message>
        <source>&amp;Large probe</source>
        <translation>&amp;Stor kule</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>&amp;Minste</translation>
    </message>
    <message>
        <source> Å</source>
        <translation> Å</translation>
    </message>
    <message>
        <source>Looking for pockets …</source>
        <translation>Leter etter lommer …</translation>
    </message>
    <message>
        <source>Open a protein from a PDB or mmCIF file to see its pockets here.</source>
        <translation>Åpne et protein fra en PDB- eller mmCIF-fil for å se lommene her.</translation>
    </message>
    <message>
        <source>Nothing was looked for. Change a radius to start.</source>
        <translation>Det ble ikke lett. Endre en radius for å begynne.</translation>
    </message>
    <message numerus="yes">
        <source>%n pockets</source>
        <translation>
            <numerusform>%n lomme</numerusform>
            <numerusform>%n lommer</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket %1 in Focus</source>
        <translation>Lomme %1 i fokus</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Innstillinger</translation>
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
        <translation>Ingen etikett her nevner noe å spørre om</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <comment>answers of a quiz</comment>
        <translation>%1 av %2 riktige</translation>
    </message>
    <message>
        <source>%1 / %2   Point at: %3</source>
        <comment>number of the question, of so many, what to point at</comment>
        <translation>%1 / %2   Pek på: %3</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <comment>answer of a quiz</comment>
        <translation>Riktig: %1</translation>
    </message>
    <message>
        <source>No, that is: %1. Outlined is: %2</source>
        <comment>answer of a quiz</comment>
        <translation>Nei, det er: %1. Omrisset er: %2</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PresenterWindow</name>
    <message>
        <source>Notes</source>
        <translation>Notater</translation>
    </message>
    <message>
        <source>The next view</source>
        <translation>Den neste visningen</translation>
    </message>
    <message>
        <source>This is the last view</source>
        <translation>Dette er den siste visningen</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Neste: %1</translation>
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
        <translation>Disse i detalj, alt annet etter hva det er for dem</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontekst</translation>
    </message>
    <message>
        <source>These as contours</source>
        <translation>Disse som konturer</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Skygge</translation>
    </message>
    <message>
        <source>These as their outer edges alone</source>
        <translation>Disse bare med ytterkantene</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Skjult</translation>
    </message>
    <message>
        <source>Hides these</source>
        <translation>Skjuler disse</translation>
    </message>
    <message>
        <source>My presets</source>
        <translation>Mine forvalg</translation>
    </message>
    <message>
        <source>Looks that you have named</source>
        <translation>Utseender du har gitt navn</translation>
    </message>
    <message>
        <source>&amp;Save This Look…</source>
        <translation>&amp;Lagre dette utseendet …</translation>
    </message>
    <message>
        <source>&amp;Manage…</source>
        <translation>&amp;Behandle …</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PrintProofDialog</name>
    <message>
        <source>in grey</source>
        <translation>i grått</translation>
    </message>
    <message>
        <source>with protanopia</source>
        <translation>med protanopi</translation>
    </message>
    <message>
        <source>with deuteranopia</source>
        <translation>med deuteranopi</translation>
    </message>
    <message>
        <source>with tritanopia</source>
        <translation>med tritanopi</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>på skjermen</translation>
    </message>
    <message>
        <source>Neighbours that look alike</source>
        <translation>Naboer som ser like ut</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Naboer</translation>
    </message>
    <message>
        <source>Look alike</source>
        <translation>Ser like ut</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Hva som ville hjelpe</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Ny</translation>
    </message>
    <message>
        <source>&amp;Also what looks alike on the screen</source>
        <translation>&amp;Også det som ser likt ut på skjermen</translation>
    </message>
    <message>
        <source>&amp;With the changes</source>
        <translation>&amp;Med endringene</translation>
    </message>
    <message>
        <source>Make the &amp;Changes</source>
        <translation>&amp;Gjør endringene</translation>
    </message>
    <message>
        <source>Print Proof</source>
        <translation>Prøvetrykk</translation>
    </message>
    <message>
        <source>Which may be meant: both kidneys have one colour</source>
        <translation>Som kan være ment: begge nyrene har én farge</translation>
    </message>
    <message>
        <source>As it is seen</source>
        <translation>Slik det ses</translation>
    </message>
    <message>
        <source>Seen %1</source>
        <translation>Sett %1</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Forhåndsvisning</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Lukk</translation>
    </message>
    <message>
        <source>Looking at the picture…</source>
        <translation>Ser på bildet …</translation>
    </message>
    <message>
        <source>All neighbours can be told apart in grey and by all eyes.</source>
        <translation>Alle naboer kan skilles fra hverandre i grått og av alle øyne.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of neighbours look alike in print or to some eyes.</source>
        <translation>
            <numerusform>%n par naboer ser likt ut på trykk eller for noen øyne.</numerusform>
            <numerusform>%n par naboer ser like ut på trykk eller for noen øyne.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n of them no change was found.</source>
        <translation>
            <numerusform>For %n av dem ble det ikke funnet noen endring.</numerusform>
            <numerusform>For %n av dem ble det ikke funnet noen endring.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 og %2</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>farge</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Tegner …</translation>
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
        <translation>Gjenopprett ulagret arbeid</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Senere</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Programmet avsluttet ikke som det skulle. Det hadde tatt vare på:</translation>
    </message>
</context>
<context>
    <name>sline::widgets::RecoveryList</name>
    <message>
        <source>A damaged copy</source>
        <translation>En skadet kopi</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>aldri lagret</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Gjenopprett</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slett</translation>
    </message>
    <message>
        <source>Delete the unsaved work on “%1”?</source>
        <translation>Vil du slette det ulagrede arbeidet med «%1»?</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Det kan ikke hentes tilbake.</translation>
    </message>
    <message>
        <source>%1, in an unknown folder</source>
        <translation>%1, i en ukjent mappe</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SavePresetDialog</name>
    <message>
        <source>Save Preset</source>
        <translation>Lagre forvalg</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Navn</translation>
    </message>
    <message>
        <source>What it keeps of the look:</source>
        <translation>Hva det tar vare på av utseendet:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Erstatt</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Lagre</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ScaleBarMark</name>
    <message>
        <source>Scale: %1</source>
        <translation>Målestokk: %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionActions</name>
    <message>
        <source>Without %1 Section</source>
        <translation>Uten snitt: %1</translation>
    </message>
    <message>
        <source>Flip Sections</source>
        <translation>Vend snitt</translation>
    </message>
    <message>
        <source>Whole Again</source>
        <translation>Hel igjen</translation>
    </message>
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittalt</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Koronalt</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Aksialt</translation>
    </message>
    <message>
        <source>%1 cannot be added: a structure can have %2 sections at most</source>
        <translation>%1 kan ikke legges til: en struktur kan ha høyst %2 snitt</translation>
    </message>
    <message>
        <source>Take another section away first</source>
        <translation>Ta først bort et annet snitt</translation>
    </message>
    <message>
        <source>Of %1 alone</source>
        <translation>Bare av %1</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>På &amp;tvers av blikket</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionList</name>
    <message>
        <source>Section</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posisjon</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Skjærer</translation>
    </message>
    <message>
        <source>Rename Section</source>
        <translation>Gi snittet nytt navn</translation>
    </message>
    <message>
        <source>Section On</source>
        <translation>Snitt på</translation>
    </message>
    <message>
        <source>Section Off</source>
        <translation>Snitt av</translation>
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
        <translation>Vend snittet</translation>
    </message>
    <message>
        <source>Tilt Section</source>
        <translation>Vipp snittet</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Flytt snittet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionsPanel</name>
    <message>
        <source>Sections</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ny</translation>
    </message>
    <message>
        <source>Add a section plane</source>
        <translation>Legg til et snittplan</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Vend</translation>
    </message>
    <message>
        <source>Keep the other side of this section</source>
        <translation>Behold den andre siden av dette snittet</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slett</translation>
    </message>
    <message>
        <source>Take this section away</source>
        <translation>Ta bort dette snittet</translation>
    </message>
    <message>
        <source>Flip Section</source>
        <translation>Vend snittet</translation>
    </message>
    <message>
        <source>Towards the left, the back or the head; of an oblique section along its normal</source>
        <translation>Mot venstre, ryggen eller hodet; for et skrått snitt langs normalen</translation>
    </message>
    <message>
        <source>Hatched cut faces</source>
        <translation>Skraverte snittflater</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Flytt snittet</translation>
    </message>
    <message>
        <source>Hatched Cut Faces</source>
        <translation>Skraverte snittflater</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Posisjon</translation>
    </message>
    <message>
        <source>&amp;Cuts</source>
        <translation>S&amp;kjærer</translation>
    </message>
    <message>
        <source>Delete Section</source>
        <translation>Slett snittet</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Valgt: %1</translation>
    </message>
    <message>
        <source>What a Section Cuts</source>
        <translation>Hva et snitt skjærer</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papir</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tone</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Vev</translation>
    </message>
    <message>
        <source>Cut faces as white as the paper, in a tint of the structure&apos;s colour, or with the pattern of its tissue as in printed atlases</source>
        <translation>Snittflater så hvite som papiret, i en tone av strukturens farge eller med mønsteret til vevet som i trykte atlas</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Snittflater</translation>
    </message>
    <message>
        <source>Cut Faces</source>
        <translation>Snittflater</translation>
    </message>
    <message>
        <source>Along the X, the Y or the Z axis; of an oblique section along its normal</source>
        <translation>Langs X-, Y- eller Z-aksen; for et skrått snitt langs normalen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SelectionPanel</name>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Farge …</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Aksesystem</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Enhet</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Glatting</translation>
    </message>
    <message>
        <source>Fewer &amp;triangles</source>
        <translation>Færre &amp;trekanter</translation>
    </message>
    <message>
        <source>As for all</source>
        <translation>Som for alle</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Ulike</translation>
    </message>
    <message numerus="yes">
        <source>For the selected %n structures</source>
        <translation>
            <numerusform>For den valgte strukturen</numerusform>
            <numerusform>For de valgte %n strukturene</numerusform>
        </translation>
    </message>
    <message>
        <source>Select structures to treat them unlike the others</source>
        <translation>Velg strukturer for å behandle dem annerledes enn de andre</translation>
    </message>
    <message>
        <source>For “%1”</source>
        <translation>For «%1»</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 og %n til</numerusform>
            <numerusform>%1 og %n til</numerusform>
        </translation>
    </message>
    <message>
        <source>No file that could be read again has changed</source>
        <translation>Ingen fil som kan leses på nytt, er endret</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read again</source>
        <translation>
            <numerusform>%n struktur ble lest på nytt</numerusform>
            <numerusform>%n strukturer ble lest på nytt</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from source</source>
        <translation>Last inn på nytt fra kilden</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Åpne %1</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>Lukk %1</translation>
    </message>
    <message>
        <source>Revert to Saved</source>
        <translation>Tilbake til lagret</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Lås opp</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Skjul</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 for %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n items</source>
        <translation>
            <numerusform>%1 for %n element</numerusform>
            <numerusform>%1 for %n elementer</numerusform>
        </translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Legg til %1</translation>
    </message>
    <message>
        <source>One of them has reached the end, and all keep their differences. A drag with Shift makes them equal.</source>
        <translation>Én er kommet til enden, og alle beholder forskjellene sine. Å dra med Shift gjør dem like.</translation>
    </message>
    <message>
        <source>Structures that differ keep their differences; with Shift all become equal</source>
        <translation>Strukturer som er ulike, beholder forskjellene sine; med Shift blir alle like</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Uten navn</translation>
    </message>
    <message>
        <source>Nobody has said how long the unit of its files is, and not all has the size that it should have: lengths stand with a “?”</source>
        <translation>Ingen har sagt hvor lang enheten i filene er, og ikke alt har den størrelsen det burde ha: lengder står med «?»</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SidesActions</name>
    <message>
        <source>Left and right</source>
        <translation>Venstre og høyre</translation>
    </message>
    <message>
        <source>Sides are right</source>
        <translation>Sidene stemmer</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Speilvend</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drei</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Spør senere</translation>
    </message>
    <message>
        <source>Ask later: the menu Edit has the same answers</source>
        <translation>Spør senere: menyen Rediger har de samme svarene</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Speilvend venstre og høyre</translation>
    </message>
    <message>
        <source>Turn about the body&apos;s axis</source>
        <translation>Drei om kroppens akse</translation>
    </message>
    <message>
        <source>Left and right are not certain: names or places contradict the frame.</source>
        <translation>Venstre og høyre er ikke sikre: navn eller steder motsier koordinatsystemet.</translation>
    </message>
    <message>
        <source>Left and right are not certain: they were assumed.</source>
        <translation>Venstre og høyre er ikke sikre: de ble antatt.</translation>
    </message>
    <message>
        <source>Read as %1 (%2).</source>
        <translation>Lest som %1 (%2).</translation>
    </message>
    <message>
        <source>Front and back are not certain: names tell left and right alone.</source>
        <translation>Foran og bak er ikke sikkert: navn sier bare venstre og høyre.</translation>
    </message>
    <message>
        <source>Names are right</source>
        <translation>Navnene stemmer</translation>
    </message>
    <message>
        <source>Labels show such names with a question mark, and no question asks for them.</source>
        <translation>Etiketter viser slike navn med spørsmålstegn, og ingen spørsmål spør etter dem.</translation>
    </message>
    <message>
        <source>Nothing tells that z leads to the head; it was assumed.</source>
        <translation>Ingenting sier at z fører mot hodet; det ble antatt.</translation>
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
        <translation>Sist åpnet</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Demos, Modelled by the Program</source>
        <translation>Demoer, modellert av programmet</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>Focus-and-context line drawings of anatomy</source>
        <translation>Strektegninger av anatomi med fokus og kontekst</translation>
    </message>
    <message>
        <source>Open Files…</source>
        <translation>Åpne filer …</translation>
    </message>
    <message>
        <source>Open Folder…</source>
        <translation>Åpne mappe …</translation>
    </message>
    <message>
        <source>or drop files and folders into this window</source>
        <translation>eller slipp filer og mapper i dette vinduet</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Programmet avsluttet ikke som det skulle. Det hadde tatt vare på:</translation>
    </message>
    <message>
        <source>no longer there</source>
        <translation>ikke der lenger</translation>
    </message>
    <message>
        <source>Drawing Style for What Is Opened Next</source>
        <translation>Tegnestil for det som åpnes neste gang</translation>
    </message>
    <message>
        <source>Demos and scene files keep their own</source>
        <translation>Demoer og scenefiler beholder sin egen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureActions</name>
    <message>
        <source>Context</source>
        <translation>Kontekst</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureDelegate</name>
    <message>
        <source>Name</source>
        <translation>Navn</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureProperties</name>
    <message>
        <source>Properties</source>
        <translation>Egenskaper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopier</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Tegnet</translation>
    </message>
    <message>
        <source>Authors</source>
        <translation>Opphavspersoner</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Kilde</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lisens</translation>
    </message>
    <message>
        <source>Whose work the surface is; exports print it where you wish</source>
        <translation>Hvem som har laget flaten; eksporter skriver det der du ønsker</translation>
    </message>
    <message>
        <source>several</source>
        <translation>flere</translation>
    </message>
    <message>
        <source>Say Whose Work It Is</source>
        <translation>Si hvem som har laget det</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTree</name>
    <message>
        <source>Filter structures by name</source>
        <translation>Filtrer strukturer etter navn</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrer etter navn</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farge</translation>
    </message>
    <message>
        <source>No structure is called so</source>
        <translation>Ingen struktur heter det</translation>
    </message>
    <message numerus="yes">
        <source>%n structures – Enter selects them</source>
        <translation>
            <numerusform>%n struktur – Enter velger den</numerusform>
            <numerusform>%n strukturer – Enter velger dem</numerusform>
        </translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either. Enter selects all that match, Down goes to the list, Escape shows all again.</source>
        <translation>Ord i vilkårlig rekkefølge; «%1» eller et komma mellom dem finner begge deler. Enter velger alle som passer, pil ned går til listen, Esc viser alle igjen.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeModel</name>
    <message>
        <source>Hidden</source>
        <translation>Skjult</translation>
    </message>
    <message>
        <source>Partly shown</source>
        <translation>Delvis vist</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Vist</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>%1, from the group above</source>
        <translation>%1, fra gruppen over</translation>
    </message>
    <message>
        <source>%1, structures: %2</source>
        <translation>%1, strukturer: %2</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Gi nytt navn</translation>
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
        <translation>%1, egen</translation>
    </message>
    <message>
        <source>Colour, its own</source>
        <translation>Farge, egen</translation>
    </message>
    <message>
        <source>Colours of what is in it</source>
        <translation>Fargene til det som er i den</translation>
    </message>
    <message>
        <source>Colour, from the group above</source>
        <translation>Farge, fra gruppen over</translation>
    </message>
    <message>
        <source>opacity %1 %, its own</source>
        <translation>dekkevne %1 %, egen</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>dekkevne %1 %</translation>
    </message>
    <message>
        <source>Not locked</source>
        <translation>Ikke låst</translation>
    </message>
    <message>
        <source>Locked by the group above: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Låst av gruppen over: beholder utseende, navn og plass og kan ikke klikkes i bildet</translation>
    </message>
    <message>
        <source>Locked: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Låst: beholder utseende, navn og plass og kan ikke klikkes i bildet</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 til %2</translation>
    </message>
    <message>
        <source>%1: lies on the other side than its name says</source>
        <translation>%1: ligger på den andre siden enn navnet sier</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeView</name>
    <message>
        <source>Structures</source>
        <translation>Strukturer</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Låst</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleActions</name>
    <message>
        <source>Paste Style</source>
        <translation>Lim inn stilen</translation>
    </message>
    <message>
        <source>Paste Style, Keep Colour</source>
        <translation>Lim inn stilen, behold fargen</translation>
    </message>
    <message>
        <source>Make Like</source>
        <translation>Gjør lik</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleChoiceEditor</name>
    <message>
        <source>Several</source>
        <translation>Flere</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleColourEditor</name>
    <message>
        <source>Several</source>
        <translation>Flere</translation>
    </message>
    <message>
        <source>With the background</source>
        <translation>Med bakgrunnen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleEditor</name>
    <message>
        <source>Reset</source>
        <translation>Tilbakestill</translation>
    </message>
    <message>
        <source>As the group above, or the usual, says</source>
        <translation>Slik gruppen over, eller det vanlige, sier</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Tilbakestill %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SubjectPopup</name>
    <message>
        <source>Working out other plates…</source>
        <translation>Andre plansjer utarbeides …</translation>
    </message>
    <message>
        <source>Other subjects</source>
        <translation>Andre motiver</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdEditor</name>
    <message>
        <source>Thresholds of lines</source>
        <translation>Terskler for linjer</translation>
    </message>
    <message>
        <source>How strong lines must be for their technique to draw them</source>
        <translation>Hvor sterke linjer må være for at teknikken skal tegne dem</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdPanel</name>
    <message>
        <source>Bone</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Hud</translation>
    </message>
    <message>
        <source>Contrast vessels</source>
        <translation>Kar med kontrast</translation>
    </message>
    <message>
        <source>&amp;Keep the scan with the scene (for slices)</source>
        <translation>Be&amp;hold opptaket i scenen (for snitt)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Opptak</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slice through the middle</source>
        <translation>Aksialt, koronalt og sagittalt snitt gjennom midten</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Navn på strukturen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Navn</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Fra</translation>
    </message>
    <message>
        <source>t&amp;o</source>
        <translation>t&amp;il</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HU</translation>
    </message>
    <message>
        <source>No structure is made of the scan yet</source>
        <translation>Ingen struktur er laget av opptaket ennå</translation>
    </message>
    <message>
        <source>Made of scans: %1</source>
        <translation>Laget av opptak: %1</translation>
    </message>
    <message>
        <source>&amp;Add structure</source>
        <translation>&amp;Legg til struktur</translation>
    </message>
    <message>
        <source>&amp;Add another structure</source>
        <translation>&amp;Legg til en struktur til</translation>
    </message>
</context>
<context>
    <name>sline::widgets::TourActions</name>
    <message>
        <source>Views</source>
        <translation>Visninger</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewActions</name>
    <message>
        <source>Key Light</source>
        <translation>Hovedlys</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewCard</name>
    <message>
        <source>Name of the view</source>
        <translation>Navn på visningen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewList</name>
    <message numerus="yes">
        <source>%n of the structures and labels it shows are no longer in the scene</source>
        <translation>
            <numerusform>%n av strukturene og etikettene den viser, finnes ikke lenger i scenen</numerusform>
            <numerusform>%n av strukturene og etikettene den viser, finnes ikke lenger i scenen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewRow</name>
    <message>
        <source>Saved views</source>
        <translation>Lagrede visninger</translation>
    </message>
    <message>
        <source>A view keeps what you see: camera, what is shown, Γ, colours and sections</source>
        <translation>En visning tar vare på det du ser: kamera, hva som vises, Γ, farger og snitt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewTour</name>
    <message>
        <source>View “%1”</source>
        <translation>Visning «%1»</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Visning %1</translation>
    </message>
    <message>
        <source>Add View</source>
        <translation>Legg til visning</translation>
    </message>
    <message>
        <source>Update View “%1”</source>
        <translation>Oppdater visning «%1»</translation>
    </message>
    <message>
        <source>Delete View “%1”</source>
        <translation>Slett visning «%1»</translation>
    </message>
    <message>
        <source>Rename View</source>
        <translation>Gi visning nytt navn</translation>
    </message>
    <message>
        <source>Move View</source>
        <translation>Flytt visning</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewWordsEditor</name>
    <message>
        <source>What is to be read with the view</source>
        <translation>Det som skal leses sammen med visningen</translation>
    </message>
    <message>
        <source>Notes for who presents the view</source>
        <translation>Notater for den som viser visningen</translation>
    </message>
    <message>
        <source>For you alone, while you present: no file for others has them</source>
        <translation>Bare for deg mens du viser: ingen fil for andre har dem</translation>
    </message>
    <message>
        <source>Title of the view</source>
        <translation>Tittel på visningen</translation>
    </message>
    <message>
        <source>What the view is called where it is shown, if that is not its name</source>
        <translation>Hva visningen heter der den vises, om det ikke er navnet dens</translation>
    </message>
    <message>
        <source>How long the view is shown</source>
        <translation>Hvor lenge visningen vises</translation>
    </message>
    <message>
        <source>How long a film rests at the view; 0 for as long as at the others</source>
        <translation>Hvor lenge en film hviler ved visningen; 0 for like lenge som ved de andre</translation>
    </message>
    <message>
        <source> s</source>
        <comment>seconds</comment>
        <translation> s</translation>
    </message>
    <message>
        <source>as others</source>
        <comment>how long a view is shown</comment>
        <translation>som andre</translation>
    </message>
    <message>
        <source>Change What a View Says</source>
        <translation>Endre hva en visning sier</translation>
    </message>
    <message>
        <source>Choose a view</source>
        <translation>Velg en visning</translation>
    </message>
    <message>
        <source>Text, to be read with the view</source>
        <translation>Tekst, å lese sammen med visningen</translation>
    </message>
    <message>
        <source>Notes, for who presents it</source>
        <translation>Notater, for den som viser den</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Hva visningen viser</translation>
    </message>
    <message>
        <source>For who does not see the picture: files for others have it, and without it they say what is seen</source>
        <translation>For den som ikke ser bildet: filer for andre har det, og uten det sier de hva som er å se</translation>
    </message>
    <message>
        <source>Description, for who does not see it</source>
        <translation>Beskrivelse, for den som ikke ser det</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Bilde</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewsPanel</name>
    <message>
        <source>Update View</source>
        <translation>Oppdater visning</translation>
    </message>
    <message>
        <source>The chosen view shows from now on what is seen now</source>
        <translation>Den valgte visningen viser fra nå av det som ses nå</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Slett</translation>
    </message>
    <message>
        <source>Take the chosen view away</source>
        <translation>Ta bort den valgte visningen</translation>
    </message>
    <message>
        <source>Text, Notes</source>
        <translation>Tekst, notater</translation>
    </message>
    <message>
        <source>Show what the chosen view says, to be typed below</source>
        <translation>Vis hva den valgte visningen sier, å skrive nedenfor</translation>
    </message>
</context>
</TS>
