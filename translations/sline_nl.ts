<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>Told</name>
    <message>
        <source>line %1</source>
        <translation>regel %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>byte %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>hoekpunt %1</translation>
    </message>
    <message>
        <source>vertex %1 in %2</source>
        <translation>hoekpunt %1 in %2</translation>
    </message>
    <message>
        <source>it cannot be written: %1</source>
        <translation>kan niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>it cannot be put in its place: %1</source>
        <translation>kan niet op zijn plaats worden gezet: %1</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>kan niet worden gelezen: %1</translation>
    </message>
    <message>
        <source>its folder cannot be written to: %1</source>
        <translation>in de map kan niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>it is open for writing in %1</source>
        <translation>is om te schrijven geopend in: %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>een ander programma</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>is een map</translation>
    </message>
    <message>
        <source>%1; the file that was there is whole, as it was</source>
        <translation>%1; het bestand dat daar stond is nog heel</translation>
    </message>
    <message>
        <source>it is larger than %1 bytes</source>
        <translation>is groter dan %1 bytes</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>de map kan niet worden gemaakt: %1</translation>
    </message>
    <message>
        <source>it is a file, and a folder is to be made</source>
        <translation>is een bestand, en er moet een map komen</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>de map kan niet worden gelezen: %1</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>de map is niet leeg</translation>
    </message>
    <message>
        <source>no temporary folder can be made here: %1</source>
        <translation>hier kan geen tijdelijke map worden gemaakt: %1</translation>
    </message>
    <message>
        <source>Choose a folder that exists and that you may write to</source>
        <translation>Kies een map die bestaat en waarin u mag schrijven</translation>
    </message>
    <message>
        <source>Choose a place that exists and that you may write to</source>
        <translation>Kies een plaats die bestaat en waar u mag schrijven</translation>
    </message>
    <message>
        <source>Free some space on the disk, or choose another one</source>
        <translation>Maak ruimte op de schijf of kies een andere</translation>
    </message>
    <message>
        <source>Free some space on its disk</source>
        <translation>Maak ruimte op de schijf</translation>
    </message>
    <message>
        <source>Check the rights of its folder</source>
        <translation>Controleer de rechten van de map</translation>
    </message>
    <message>
        <source>Check the name and the rights</source>
        <translation>Controleer de naam en de rechten</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>Noem een bestand</translation>
    </message>
    <message>
        <source>Name the right file</source>
        <translation>Noem het juiste bestand</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet</source>
        <translation>Noem een map die er nog niet is</translation>
    </message>
    <message>
        <source>Name a folder that is not there yet, or an empty one</source>
        <translation>Noem een map die er nog niet is of die leeg is</translation>
    </message>
    <message>
        <source>Save it under another name or in another folder</source>
        <translation>Sla het op onder een andere naam of in een andere map</translation>
    </message>
    <message>
        <source>Close it there, or save it under another name</source>
        <translation>Sluit het daar of sla het op onder een andere naam</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>Sla op onder een andere naam</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>is leeg</translation>
    </message>
    <message>
        <source>it is no whole ZIP file: %1</source>
        <translation>is geen volledig ZIP-bestand: %1</translation>
    </message>
    <message>
        <source>it is cut or damaged</source>
        <translation>is afgekapt of beschadigd</translation>
    </message>
    <message>
        <source>it holds no scene.json: it is a ZIP file, but no scene</source>
        <translation>bevat geen scene.json: een ZIP-bestand, maar geen scène</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>is te groot</translation>
    </message>
    <message>
        <source>a newer version of the program has written it, with more than this one would write</source>
        <translation>een nieuwere versie van het programma heeft het geschreven, met meer dan deze zou schrijven</translation>
    </message>
    <message>
        <source>it was damaged, and holds no state of the scene that is whole</source>
        <translation>was beschadigd en bevat geen volledige stand van de scène</translation>
    </message>
    <message>
        <source>Open an older copy of it, or import the meshes again</source>
        <translation>Open een oudere kopie of importeer de meshes opnieuw</translation>
    </message>
    <message>
        <source>Open the scene file as it was saved last</source>
        <translation>Open het scènebestand zoals het het laatst opgeslagen is</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>dit bestand bestaat niet</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>dit bestand of deze map bestaat niet</translation>
    </message>
    <message>
        <source>is a folder, not a mesh file</source>
        <translation>is een map, geen meshbestand</translation>
    </message>
    <message>
        <source>is a device or pipe, not a file</source>
        <translation>is een apparaat of pipe, geen bestand</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kan niet worden geopend: %1</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>is leeg</translation>
    </message>
    <message>
        <source>its size cannot be found: %1</source>
        <translation>de grootte is niet te vinden: %1</translation>
    </message>
    <message>
        <source>has %1 bytes, the limit is %2</source>
        <translation>heeft %1 bytes, de grens is %2</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory</source>
        <translation>heeft %1 bytes geheugen nodig</translation>
    </message>
    <message>
        <source>needs %1 bytes of memory when unpacked</source>
        <translation>heeft uitgepakt %1 bytes geheugen nodig</translation>
    </message>
    <message>
        <source>cannot be read any further</source>
        <translation>kan niet verder worden gelezen</translation>
    </message>
    <message>
        <source>its packed bytes end in the middle</source>
        <translation>de ingepakte bytes eindigen halverwege</translation>
    </message>
    <message>
        <source>holds nothing when unpacked</source>
        <translation>bevat uitgepakt niets</translation>
    </message>
    <message>
        <source>this kind of file is not supported</source>
        <translation>dit soort bestand wordt niet ondersteund</translation>
    </message>
    <message>
        <source>has no extension that tells its kind</source>
        <translation>heeft geen extensie die het soort noemt</translation>
    </message>
    <message>
        <source>files of kind &apos;%1&apos; are not supported</source>
        <translation>bestanden van het soort ‘%1’ worden niet ondersteund</translation>
    </message>
    <message>
        <source>%1; its content looks like %2</source>
        <translation>%1; de inhoud ziet eruit als: %2</translation>
    </message>
    <message>
        <source>the folder holds no mesh</source>
        <translation>de map bevat geen mesh</translation>
    </message>
    <message>
        <source>%1 is an archive and was not looked into</source>
        <translation>%1 is een archief waarin niet is gekeken</translation>
    </message>
    <message>
        <source>%1 are archives and were not looked into</source>
        <translation>%1 zijn archieven waarin niet is gekeken</translation>
    </message>
    <message>
        <source>is an archive, which is not looked into</source>
        <translation>is een archief, waarin niet wordt gekeken</translation>
    </message>
    <message>
        <source>Unpack it and open what was in it</source>
        <translation>Pak het uit en open wat erin zat</translation>
    </message>
    <message>
        <source>Open a bundle of 3D Slicer (.mrb) by itself; unpack any other and open what was in it</source>
        <translation>Open een bundel van 3D Slicer (.mrb) apart; pak elk ander archief uit en open wat erin zat</translation>
    </message>
    <message>
        <source>the scene holds no model</source>
        <translation>de scène bevat geen model</translation>
    </message>
    <message>
        <source>none of the scene&apos;s %1 model files can be found</source>
        <translation>geen van de %1 modelbestanden van de scène is te vinden</translation>
    </message>
    <message>
        <source>there is nothing to read</source>
        <translation>er is niets te lezen</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>de import is afgebroken</translation>
    </message>
    <message>
        <source>all structures are left out</source>
        <translation>alle structuren zijn weggelaten</translation>
    </message>
    <message>
        <source>nothing is made of the scan yet</source>
        <translation>van de scan is nog niets gemaakt</translation>
    </message>
    <message>
        <source>holds no triangles</source>
        <translation>bevat geen driehoeken</translation>
    </message>
    <message>
        <source>holds no vertices</source>
        <translation>bevat geen hoekpunten</translation>
    </message>
    <message>
        <source>holds vertices but no faces</source>
        <translation>bevat hoekpunten maar geen vlakken</translation>
    </message>
    <message>
        <source>holds no faces, only lines or points</source>
        <translation>bevat geen vlakken, alleen lijnen of punten</translation>
    </message>
    <message>
        <source>this is not a statement of an OBJ file</source>
        <translation>dit is geen opdracht van een OBJ-bestand</translation>
    </message>
    <message>
        <source>Check that the file is an OBJ file</source>
        <translation>Controleer of het een OBJ-bestand is</translation>
    </message>
    <message>
        <source>Export the mesh as a surface with faces</source>
        <translation>Exporteer de mesh als oppervlak met vlakken</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;ply&apos;</source>
        <translation>het bestand begint niet met ‘ply’</translation>
    </message>
    <message>
        <source>the file does not begin with &apos;OFF&apos;</source>
        <translation>het bestand begint niet met ‘OFF’</translation>
    </message>
    <message>
        <source>%1 stands where %2 should</source>
        <translation>%1 staat waar %2 hoort te staan</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>het bestand eindigt na %1</translation>
    </message>
    <message>
        <source>the file ends within a face</source>
        <translation>het bestand eindigt midden in een vlak</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles are more than the limit</source>
        <translation>%1 hoekpunten en %2 driehoeken zijn meer dan de grens</translation>
    </message>
    <message>
        <source>%1 of %2 faces refer to vertices that do not exist (there are %3 vertices)</source>
        <translation>%1 van de %2 vlakken verwijzen naar hoekpunten die niet bestaan (er zijn er %3)</translation>
    </message>
    <message>
        <source>%1 of %2 vertices are not finite numbers</source>
        <translation>%1 van de %2 hoekpunten zijn geen eindige getallen</translation>
    </message>
    <message>
        <source>the reader of %1 files crashed over this file (%2)</source>
        <translation>de lezer van %1-bestanden is op dit bestand vastgelopen (%2)</translation>
    </message>
    <message>
        <source>the reader of %1 files wanted more than %2 of memory for this file</source>
        <translation>de lezer van %1-bestanden wilde voor dit bestand meer dan %2 geheugen</translation>
    </message>
    <message>
        <source>the reader of %1 files did not come to an end within %2 s of computing</source>
        <translation>de lezer van %1-bestanden was na %2 s rekenen niet klaar</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>er is niet genoeg geheugen</translation>
    </message>
    <message>
        <source>a library failed: %1</source>
        <translation>een bibliotheek faalde: %1</translation>
    </message>
    <message>
        <source>Check the name</source>
        <translation>Controleer de naam</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Controleer het pad</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Controleer de schijf</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Controleer de rechten</translation>
    </message>
    <message>
        <source>Check the disk or copy the file again</source>
        <translation>Controleer de schijf of kopieer het bestand opnieuw</translation>
    </message>
    <message>
        <source>Copy the file again</source>
        <translation>Kopieer het bestand opnieuw</translation>
    </message>
    <message>
        <source>Copy the data to a file</source>
        <translation>Kopieer de gegevens naar een bestand</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Sluit andere programma’s</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>Sluit andere programma’s en probeer het opnieuw</translation>
    </message>
    <message>
        <source>Reduce the mesh</source>
        <translation>Verklein de mesh</translation>
    </message>
    <message>
        <source>Name a file inside it</source>
        <translation>Noem een bestand daarin</translation>
    </message>
    <message>
        <source>Name a mesh, a folder or a scene</source>
        <translation>Noem een mesh, een map of een scène</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Mogelijk zijn %1</translation>
    </message>
    <message>
        <source>%1, many of them packed (.gz) too</source>
        <translation>%1, veel daarvan ook ingepakt (.gz)</translation>
    </message>
    <message>
        <source>Give a file of surfaces (%1), a folder of them, a 3D Slicer scene (.mrml, .mrb) or its fiducials (%2), or a scene file (.sline)</source>
        <translation>Mogelijk zijn een bestand met oppervlakken (%1), een map daarvan, een scène van 3D Slicer (.mrml, .mrb) of de markeringen daarvan (%2), of een scènebestand (.sline)</translation>
    </message>
    <message>
        <source>Export the mesh again from the program that made it</source>
        <translation>Exporteer de mesh opnieuw uit het programma dat hem gemaakt heeft</translation>
    </message>
    <message>
        <source>Export the mesh as a surface of triangles</source>
        <translation>Exporteer de mesh als oppervlak van driehoeken</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind or export the mesh again</source>
        <translation>Geef het bestand de extensie van zijn soort of exporteer de mesh opnieuw</translation>
    </message>
    <message>
        <source>It may be damaged: export it again, or in another format</source>
        <translation>Misschien is het beschadigd: exporteer het opnieuw of in een ander formaat</translation>
    </message>
    <message>
        <source>Keep the scene beside its model files, or save it again with its models</source>
        <translation>Laat de scène bij haar modelbestanden of sla haar opnieuw op met de modellen</translation>
    </message>
    <message>
        <source>None of the files could be read</source>
        <translation>Geen van de bestanden kon worden gelezen</translation>
    </message>
    <message>
        <source>Include at least one</source>
        <translation>Neem er minstens één op</translation>
    </message>
    <message>
        <source>Make a structure of it by a threshold, or keep it with the scene</source>
        <translation>Maak er met een drempel een structuur van of bewaar hem bij de scène</translation>
    </message>
    <message>
        <source>%1; they are left out</source>
        <translation>%1; ze zijn weggelaten</translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation>%1; weggelaten</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelaten: %1</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <translation>%1 is weggelaten: %2</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>geen driehoeken</translation>
    </message>
    <message>
        <source>no triangles in %1</source>
        <translation>geen driehoeken in %1</translation>
    </message>
    <message>
        <source>%1 of %2 faces have fewer than three corners and are left out</source>
        <translation>%1 van de %2 vlakken hebben minder dan drie hoeken en zijn weggelaten</translation>
    </message>
    <message>
        <source>%1 (the first: %2); they and the %3 triangles that use them are left out</source>
        <translation>%1 (het eerste: %2); ze zijn weggelaten, met de %3 driehoeken die ze gebruiken</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surface: %3 left out</source>
        <translation>%1 van %2 oppervlak hersteld: %3 weggelaten</translation>
    </message>
    <message>
        <source>repaired %1 of %2 surfaces: %3 left out</source>
        <translation>%1 van %2 oppervlakken hersteld: %3 weggelaten</translation>
    </message>
    <message>
        <source>%1 face given twice</source>
        <translation>%1 dubbel vlak</translation>
    </message>
    <message>
        <source>%1 faces given twice</source>
        <translation>%1 dubbele vlakken</translation>
    </message>
    <message>
        <source>%1 face without area</source>
        <translation>%1 vlak zonder oppervlakte</translation>
    </message>
    <message>
        <source>%1 faces without area</source>
        <translation>%1 vlakken zonder oppervlakte</translation>
    </message>
    <message>
        <source>%1 face given twice, %2 without area</source>
        <translation>%1 dubbel vlak, %2 zonder oppervlakte</translation>
    </message>
    <message>
        <source>%1 faces given twice, %2 without area</source>
        <translation>%1 dubbele vlakken, %2 zonder oppervlakte</translation>
    </message>
    <message>
        <source>a piece of %1 has no consistent orientation; it stays as it is</source>
        <translation>een stuk van %1 heeft geen eenduidige oriëntatie; het blijft zoals het is</translation>
    </message>
    <message>
        <source>%1 has no face with area; left out</source>
        <translation>%1 heeft geen vlak met oppervlakte; weggelaten</translation>
    </message>
    <message>
        <source>its file has changed or is gone</source>
        <translation>het bestand is veranderd of weg</translation>
    </message>
    <message>
        <source>no threshold made a structure: no scan was read that has it</source>
        <translation>geen drempel gaf een structuur: er is geen scan gelezen die hem heeft</translation>
    </message>
    <message>
        <source>the folder could not be read to its end: %1</source>
        <translation>de map kon niet tot het einde worden gelezen: %1</translation>
    </message>
    <message>
        <source>the folder was not searched to its end: %1</source>
        <translation>de map is niet tot het einde doorzocht: %1</translation>
    </message>
    <message>
        <source>it holds too many files</source>
        <translation>hij bevat te veel bestanden</translation>
    </message>
    <message>
        <source>the file is absent; it was left out</source>
        <translation>het bestand ontbreekt; het is weggelaten</translation>
    </message>
    <message>
        <source>the scene refers to a place outside its folder; it was left out</source>
        <translation>de scène verwijst naar een plaats buiten haar map; die is weggelaten</translation>
    </message>
    <message>
        <source>a scene file is in millimetres of the patient&apos;s frame; the frame and the unit that were chosen do not apply to it</source>
        <translation>een scènebestand staat in millimeters in het assenstelsel van de patiënt; het gekozen stelsel en de eenheid gelden er niet voor</translation>
    </message>
    <message>
        <source>surfaces of a scene file keep their triangles; only what is imported is decimated</source>
        <translation>oppervlakken van een scènebestand houden hun driehoeken; alleen wat wordt geïmporteerd wordt vereenvoudigd</translation>
    </message>
    <message>
        <source>%1 structure left out that the folder also holds as surfaces</source>
        <translation>%1 structuur weggelaten die de map ook als oppervlakken bevat</translation>
    </message>
    <message>
        <source>%1 structures left out that the folder also holds as surfaces</source>
        <translation>%1 structuren weggelaten die de map ook als oppervlakken bevat</translation>
    </message>
    <message>
        <source>a scan, of which a threshold can make a structure: %1</source>
        <translation>een scan waarvan een drempel een structuur kan maken: %1</translation>
    </message>
    <message>
        <source>the scan cannot be kept: %1</source>
        <translation>de scan kan niet worden bewaard: %1</translation>
    </message>
    <message>
        <source>%1 holds no segmentation</source>
        <translation>%1 bevat geen segmentatie</translation>
    </message>
    <message>
        <source>%1 hold no segmentation</source>
        <translation>%1 bevatten geen segmentatie</translation>
    </message>
    <message>
        <source>%1 line and point elements are left out; only faces are read</source>
        <translation>%1 lijnen en punten zijn weggelaten; alleen vlakken worden gelezen</translation>
    </message>
    <message>
        <source>%1 statements are unknown and left out (the first: %2)</source>
        <translation>%1 opdrachten zijn onbekend en weggelaten (de eerste: %2)</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle of the %2 promised are ignored</source>
        <translation>%1 bytes na de laatste van de %2 aangekondigde driehoeken zijn genegeerd</translation>
    </message>
    <message>
        <source>has neither sform nor qform: which side is left is taken from names, if they tell</source>
        <translation>heeft geen sform en geen qform: welke zijde links is volgt uit de namen, als die het zeggen</translation>
    </message>
    <message>
        <source>holds %1 images of one place; the first was read</source>
        <translation>bevat %1 beelden van één plaats; het eerste is gelezen</translation>
    </message>
    <message>
        <source>intensities were rounded to 16 bits, by at most %1</source>
        <translation>intensiteiten zijn op 16 bits afgerond, met hoogstens %1</translation>
    </message>
    <message>
        <source>%1 masks hold nothing and were left out: %2</source>
        <translation>%1 maskers bevatten niets en zijn weggelaten: %2</translation>
    </message>
    <message>
        <source>%1 atom without coordinates left out</source>
        <translation>%1 atoom zonder coördinaten weggelaten</translation>
    </message>
    <message>
        <source>%1 atoms without coordinates left out</source>
        <translation>%1 atomen zonder coördinaten weggelaten</translation>
    </message>
    <message>
        <source>%1 further model left out; the first is drawn</source>
        <translation>%1 verder model weggelaten; het eerste is getekend</translation>
    </message>
    <message>
        <source>%1 further models left out; the first is drawn</source>
        <translation>%1 verdere modellen weggelaten; het eerste is getekend</translation>
    </message>
    <message>
        <source>chain %1 laid over chain %2 of %3: %4 of %5 pairs of residues, %6 % identical, RMSD %7</source>
        <translation>keten %1 over keten %2 van %3 gelegd: %4 van de %5 paren residuen, %6 % gelijk, RMSD %7</translation>
    </message>
    <message>
        <source>not laid over %1, since no chains match; it stays where its file has it</source>
        <translation>niet over %1 gelegd, omdat geen ketens overeenkomen; blijft waar het bestand het heeft</translation>
    </message>
    <message>
        <source>no file of this name was found</source>
        <translation>er is geen bestand met deze naam gevonden</translation>
    </message>
    <message>
        <source>only files that other structures came from were found</source>
        <translation>alleen bestanden waar andere structuren uit komen zijn gevonden</translation>
    </message>
    <message>
        <source>there are %1 files of this name; name the folder of the one that is meant</source>
        <translation>er zijn %1 bestanden met deze naam; noem de map van het bedoelde</translation>
    </message>
    <message>
        <source>structures from several files of this name are in the scene</source>
        <translation>in de scène zijn structuren uit meer bestanden met deze naam</translation>
    </message>
    <message>
        <source>no structure of the scene came from these of its surfaces: %1</source>
        <translation>uit deze oppervlakken komt geen structuur van de scène: %1</translation>
    </message>
    <message>
        <source>it holds no surface %1 any more</source>
        <translation>bevat geen oppervlak %1 meer</translation>
    </message>
    <message>
        <source>it has no face with area any more</source>
        <translation>heeft geen vlak met oppervlakte meer</translation>
    </message>
    <message>
        <source>chosen by the user</source>
        <translation>door u gekozen</translation>
    </message>
    <message>
        <source>no header and no left/right names: LPS assumed</source>
        <translation>geen kop en geen namen met een zijde: LPS aangenomen</translation>
    </message>
    <message>
        <source>vote: %1 of %2 left/right names</source>
        <translation>stemming: %1 van de %2 namen met een zijde</translation>
    </message>
    <message>
        <source>header: %1</source>
        <translation>kop van het bestand: %1</translation>
    </message>
    <message>
        <source>coordinates left as they are</source>
        <translation>coördinaten zoals ze zijn</translation>
    </message>
    <message>
        <source>scene of Slicer: millimetres</source>
        <translation>scène van Slicer: millimeters</translation>
    </message>
    <message>
        <source>no unit in the file: millimetres assumed</source>
        <translation>geen eenheid in het bestand: millimeters aangenomen</translation>
    </message>
    <message>
        <source>SPACE in the header</source>
        <translation>SPACE in de kop</translation>
    </message>
    <message>
        <source>SPACE in a comment</source>
        <translation>SPACE in een opmerking</translation>
    </message>
    <message>
        <source>SPACE in the field data</source>
        <translation>SPACE in de velddata</translation>
    </message>
    <message>
        <source>SPACE in the title</source>
        <translation>SPACE in de titel</translation>
    </message>
    <message>
        <source>DICOM: patient coordinates</source>
        <translation>DICOM: coördinaten van de patiënt</translation>
    </message>
    <message>
        <source>DICOM: millimetres</source>
        <translation>DICOM: millimeters</translation>
    </message>
    <message>
        <source>glTF: metres</source>
        <translation>glTF: meters</translation>
    </message>
    <message>
        <source>header: millimetres</source>
        <translation>kop van het bestand: millimeters</translation>
    </message>
    <message>
        <source>volumes are in millimetres</source>
        <translation>volumes staan in millimeters</translation>
    </message>
    <message>
        <source>modelled in it</source>
        <translation>daarin gemodelleerd</translation>
    </message>
    <message>
        <source>scene file</source>
        <translation>scènebestand</translation>
    </message>
    <message>
        <source>a molecule has no left and right</source>
        <translation>een molecuul heeft geen links en rechts</translation>
    </message>
    <message>
        <source>1 Å is drawn as 1 mm</source>
        <translation>1 Å is getekend als 1 mm</translation>
    </message>
    <message>
        <source>the export was stopped</source>
        <translation>de export is gestopt</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>Exporteer opnieuw</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large</source>
        <translation>een beeld van %1 pixels is te groot</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large for this kind of file</source>
        <translation>een beeld van %1 pixels is te groot voor dit soort bestand</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page; a side may have %1 pixels in this kind of file</source>
        <translation>Kies minder punten per inch of een kleinere pagina; een zijde mag in dit soort bestand %1 pixels hebben</translation>
    </message>
    <message>
        <source>Choose fewer dots per inch or a smaller page, or PNG or TIFF; a picture may have %1 million pixels here</source>
        <translation>Kies minder punten per inch of een kleinere pagina, of PNG of TIFF; een beeld mag hier %1 miljoen pixels hebben</translation>
    </message>
    <message>
        <source>the picture cannot be written: %1</source>
        <translation>het beeld kan niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>Choose a smaller picture or another kind of file</source>
        <translation>Kies een kleiner beeld of een ander soort bestand</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>er is te weinig geheugen</translation>
    </message>
    <message>
        <source>the picture has no labels to ask for</source>
        <translation>het beeld heeft geen bijschriften om naar te vragen</translation>
    </message>
    <message>
        <source>Label structures, or choose a view that shows some</source>
        <translation>Geef structuren bijschriften of kies een aanzicht dat er toont</translation>
    </message>
    <message>
        <source>the scene needs more than the 4 GB that a GLB file may have</source>
        <translation>de scène heeft meer nodig dan de 4 GB die een GLB-bestand mag hebben</translation>
    </message>
    <message>
        <source>Hide structures, or make them coarser</source>
        <translation>Verberg structuren of maak ze grover</translation>
    </message>
    <message>
        <source>a film takes 0.1 to 600 seconds</source>
        <translation>een film duurt 0,1 tot 600 seconden</translation>
    </message>
    <message>
        <source>Choose another length</source>
        <translation>Kies een andere duur</translation>
    </message>
    <message>
        <source>a film has 1 to 60 frames per second</source>
        <translation>een film heeft 1 tot 60 beelden per seconde</translation>
    </message>
    <message>
        <source>Choose another rate</source>
        <translation>Kies een andere snelheid</translation>
    </message>
    <message>
        <source>Save views, or make a turntable</source>
        <translation>Sla aanzichten op of maak een draaitafel</translation>
    </message>
    <message>
        <source>MP4 films are made by the program ffmpeg, which is not installed</source>
        <translation>MP4-films worden gemaakt door het programma ffmpeg, dat niet is geïnstalleerd</translation>
    </message>
    <message>
        <source>Install ffmpeg, or write an animated WebP or GIF</source>
        <translation>Installeer ffmpeg of schrijf een bewegende WebP of GIF</translation>
    </message>
    <message>
        <source>GIF films show at most 50 frames per second</source>
        <translation>GIF-films tonen hoogstens 50 beelden per seconde</translation>
    </message>
    <message>
        <source>Choose 50 or fewer, or another kind of film</source>
        <translation>Kies 50 of minder, of een ander soort film</translation>
    </message>
    <message>
        <source>the picture could not be drawn: %1</source>
        <translation>het beeld kon niet worden getekend: %1</translation>
    </message>
    <message>
        <source>Hide some structures, or close other programs to free memory</source>
        <translation>Verberg enkele structuren of sluit andere programma’s om geheugen vrij te maken</translation>
    </message>
    <message>
        <source>the structures of this scene do not fit into the memory set aside for a picture, not even piece by piece</source>
        <translation>de structuren van deze scène passen niet in het geheugen voor een beeld, ook niet stuk voor stuk</translation>
    </message>
    <message>
        <source>Hide some structures</source>
        <translation>Verberg enkele structuren</translation>
    </message>
    <message>
        <source>the driver %1 is too old: OpenGL 3.3 or OpenGL ES 3.0 is needed</source>
        <translation>het stuurprogramma %1 is te oud: OpenGL 3.3 of OpenGL ES 3.0 is nodig</translation>
    </message>
    <message>
        <source>Update the graphics driver, or install Mesa (libgl1-mesa-dri)</source>
        <translation>Werk het grafische stuurprogramma bij of installeer Mesa (libgl1-mesa-dri)</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>toegang geweigerd</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>bestand of map bestaat niet</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>geen ruimte meer op de schijf</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>de schijf kan alleen worden gelezen</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>is een map</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>is geen map</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>fout bij lezen of schrijven</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>bestand te groot</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>te veel geopende bestanden</translation>
    </message>
    <message>
        <source>it is no scene of Sline</source>
        <translation>is geen scène van Sline</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>is versleuteld</translation>
    </message>
    <message>
        <source>it cannot be unpacked: %1</source>
        <translation>kan niet worden uitgepakt: %1</translation>
    </message>
    <message>
        <source>the unit of %1 has no length</source>
        <translation>de eenheid van %1 heeft geen lengte</translation>
    </message>
    <message>
        <source>Choose a unit</source>
        <translation>Kies een eenheid</translation>
    </message>
    <message>
        <source>the steps of smoothing of %1 are out of range</source>
        <translation>het aantal stappen van afvlakking van %1 valt buiten het bereik</translation>
    </message>
    <message>
        <source>the bound for decimation of %1 is out of range</source>
        <translation>de grens voor vereenvoudiging van %1 valt buiten het bereik</translation>
    </message>
    <message>
        <source>Choose 0 to %1</source>
        <translation>Kies 0 tot %1</translation>
    </message>
    <message>
        <source>the name of %1 is empty</source>
        <translation>de naam van %1 is leeg</translation>
    </message>
    <message>
        <source>Give it a name</source>
        <translation>Geef het een naam</translation>
    </message>
    <message>
        <source>Plan the import again</source>
        <translation>Plan de import opnieuw</translation>
    </message>
    <message>
        <source>the reader of %1 files gave no answer for this file</source>
        <translation>de lezer van %1-bestanden gaf voor dit bestand geen antwoord</translation>
    </message>
    <message>
        <source>the program that reads it gave no answer</source>
        <translation>het programma dat het leest gaf geen antwoord</translation>
    </message>
    <message>
        <source>there is no memory to read it</source>
        <translation>er is geen geheugen om het te lezen</translation>
    </message>
    <message>
        <source>reading was given up</source>
        <translation>het lezen is opgegeven</translation>
    </message>
    <message>
        <source>%1 files are read by sline-reader, which is not beside Sline</source>
        <translation>%1-bestanden worden gelezen door sline-reader, dat niet naast Sline staat</translation>
    </message>
    <message>
        <source>Install Sline again</source>
        <translation>Installeer Sline opnieuw</translation>
    </message>
    <message>
        <source>Export the file again, or in another format</source>
        <translation>Exporteer het bestand opnieuw of in een ander formaat</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>heeft meer geheugen nodig dan er is</translation>
    </message>
    <message>
        <source>Import it again</source>
        <translation>Importeer het opnieuw</translation>
    </message>
    <message>
        <source>its packed bytes are damaged: they cannot be unpacked beyond byte %1</source>
        <translation>de ingepakte bytes zijn beschadigd: voorbij byte %1 zijn ze niet uit te pakken</translation>
    </message>
    <message>
        <source>too short for an STL file: not text, and its %1 bytes do not hold the header of 84</source>
        <translation>te kort voor een STL-bestand: geen tekst, en in %1 bytes past de kop van 84 niet</translation>
    </message>
    <message>
        <source>the file neither begins with &apos;solid&apos; nor has the size of a binary STL file</source>
        <translation>het bestand begint niet met ‘solid’ en heeft ook niet de grootte van een binair STL-bestand</translation>
    </message>
    <message>
        <source>Check that the file is an STL file</source>
        <translation>Controleer of het een STL-bestand is</translation>
    </message>
    <message>
        <source>the header promises %1 triangles, the file ends after %2</source>
        <translation>de kop belooft %1 driehoeken, het bestand eindigt na %2</translation>
    </message>
    <message>
        <source>the file ends where %1 should follow</source>
        <translation>het bestand eindigt waar %1 hoort te volgen</translation>
    </message>
    <message>
        <source>has no element &apos;vertex&apos;</source>
        <translation>heeft geen element ‘vertex’</translation>
    </message>
    <message>
        <source>holds points but no element &apos;face&apos; or &apos;tristrips&apos;</source>
        <translation>bevat punten maar geen element ‘face’ of ‘tristrips’</translation>
    </message>
    <message>
        <source>the header has no &apos;end_header&apos;</source>
        <translation>de kop heeft geen ‘end_header’</translation>
    </message>
    <message>
        <source>binary OFF is not supported</source>
        <translation>binair OFF wordt niet ondersteund</translation>
    </message>
    <message>
        <source>Export the mesh as text OFF</source>
        <translation>Exporteer de mesh als OFF in tekst</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>een getal</translation>
    </message>
    <message>
        <source>the volume holds nothing but background</source>
        <translation>het volume bevat niets dan achtergrond</translation>
    </message>
    <message>
        <source>Choose a volume with structures</source>
        <translation>Kies een volume met structuren</translation>
    </message>
    <message>
        <source>the borders of its structures have more than %1</source>
        <translation>de grenzen van de structuren hebben meer dan %1</translation>
    </message>
    <message>
        <source>its structures have more than %1</source>
        <translation>de structuren hebben meer dan %1</translation>
    </message>
    <message>
        <source>Check that it is a label volume, or export it with larger voxels</source>
        <translation>Controleer of het een labelvolume is of exporteer het met grotere voxels</translation>
    </message>
    <message>
        <source>does not begin like a header of NIfTI or Analyze</source>
        <translation>begint niet als een kop van NIfTI of Analyze</translation>
    </message>
    <message>
        <source>has %1 axes, a volume needs three</source>
        <translation>heeft %1 assen, een volume heeft er drie nodig</translation>
    </message>
    <message>
        <source>Export a volume with three axes in space</source>
        <translation>Exporteer een volume met drie assen in de ruimte</translation>
    </message>
    <message>
        <source>does not begin like a volume of FreeSurfer (MGH)</source>
        <translation>begint niet als een volume van FreeSurfer (MGH)</translation>
    </message>
    <message>
        <source>Put both files into one folder, or export the volume as one .nii file</source>
        <translation>Zet beide bestanden in één map of exporteer het volume als één .nii-bestand</translation>
    </message>
    <message>
        <source>is DICOM of a kind that is not known here and holds no segmentation</source>
        <translation>is DICOM van een soort die hier onbekend is en bevat geen segmentatie</translation>
    </message>
    <message>
        <source>holds no segmentation: its content is of the kind %1</source>
        <translation>bevat geen segmentatie: de inhoud is van het soort %1</translation>
    </message>
    <message>
        <source>Give the DICOM segmentation or RT structure set that was made from it</source>
        <translation>Open de DICOM-segmentatie of RT-structuurset die ervan gemaakt is</translation>
    </message>
    <message>
        <source>Copy or export the file again; it is incomplete or damaged</source>
        <translation>Kopieer of exporteer het bestand opnieuw; het is onvolledig of beschadigd</translation>
    </message>
    <message>
        <source>the file ends within an element, or an element promises more bytes than are left</source>
        <translation>het bestand eindigt in een element, of een element belooft meer bytes dan er over zijn</translation>
    </message>
    <message>
        <source>is not a DICOM file: neither &apos;DICM&apos; nor an element stands where it should</source>
        <translation>is geen DICOM-bestand: ‘DICM’ noch een element staat waar het hoort</translation>
    </message>
    <message>
        <source>Give the file the extension of its kind</source>
        <translation>Geef het bestand de extensie van zijn soort</translation>
    </message>
    <message>
        <source>is a single slice, which makes no volume</source>
        <translation>is een enkele plak, die geen volume geeft</translation>
    </message>
    <message>
        <source>its slices do not lie above each other on one grid</source>
        <translation>de plakken liggen niet op één raster boven elkaar</translation>
    </message>
    <message>
        <source>its slices are not evenly spaced; some moved by %1 mm</source>
        <translation>de plakken liggen niet even ver uiteen; sommige zijn %1 mm verschoven</translation>
    </message>
    <message>
        <source>Give all slices of the series, or have another program resample it evenly</source>
        <translation>Open alle plakken van de serie of laat een ander programma haar gelijkmatig maken</translation>
    </message>
    <message>
        <source>Give the slices of one series, of one orientation and size</source>
        <translation>Open de plakken van één serie, één oriëntatie en één grootte</translation>
    </message>
    <message>
        <source>none of its segments has a pixel</source>
        <translation>geen van de segmenten heeft een pixel</translation>
    </message>
    <message>
        <source>its contours enclose nothing; left out</source>
        <translation>de contouren omsluiten niets; weggelaten</translation>
    </message>
    <message>
        <source>has no contour; left out</source>
        <translation>heeft geen contour; weggelaten</translation>
    </message>
    <message>
        <source>holds points or open lines only; left out</source>
        <translation>bevat alleen punten of open lijnen; weggelaten</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>de XML is kapot: %1</translation>
    </message>
    <message>
        <source>Save the scene again in 3D Slicer</source>
        <translation>Sla de scène opnieuw op in 3D Slicer</translation>
    </message>
    <message>
        <source>it is XML, but no 3D Slicer scene: there is no &lt;MRML&gt;</source>
        <translation>is XML maar geen scène van 3D Slicer: er is geen &lt;MRML&gt;</translation>
    </message>
    <message>
        <source>Choose the .mrml file that 3D Slicer saved</source>
        <translation>Kies het .mrml-bestand dat 3D Slicer heeft opgeslagen</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>het bestand is leeg</translation>
    </message>
    <message>
        <source>Save the fiducials again in 3D Slicer</source>
        <translation>Sla de markeringen opnieuw op in 3D Slicer</translation>
    </message>
    <message>
        <source>the scene has no saved views to tour</source>
        <translation>de scène heeft geen bewaarde aanzichten voor een rondgang</translation>
    </message>
    <message>
        <source>the scene has one saved view alone: there is no way to go</source>
        <translation>de scène heeft maar één bewaard aanzicht: er is geen weg te gaan</translation>
    </message>
    <message>
        <source>rests of %1 seconds leave no time to move in a film of %2</source>
        <translation>bij rusten van %1 seconden blijft in een film van %2 geen tijd over om te bewegen</translation>
    </message>
    <message>
        <source>Make the rests shorter or the film longer</source>
        <translation>Maak de rusten korter of de film langer</translation>
    </message>
    <message>
        <source>frames of %1 pixels are none for a film</source>
        <translation>beelden van %1 pixels zijn niets voor een film</translation>
    </message>
    <message>
        <source>Choose a size of which both sides have 16 to 4320 pixels</source>
        <translation>Kies een grootte waarbij beide zijden 16 tot 4320 pixels hebben</translation>
    </message>
    <message>
        <source>the ffmpeg that is installed has no encoder for MP4 films</source>
        <translation>de geïnstalleerde ffmpeg heeft geen encoder voor MP4-films</translation>
    </message>
    <message>
        <source>Install an ffmpeg with libx264, or write an animated WebP or GIF</source>
        <translation>Installeer een ffmpeg met libx264 of schrijf een bewegende WebP of GIF</translation>
    </message>
    <message>
        <source>the film cannot be made: %1</source>
        <translation>de film kan niet worden gemaakt: %1</translation>
    </message>
    <message>
        <source>Make it smaller, or of another kind</source>
        <translation>Maak hem kleiner of van een ander soort</translation>
    </message>
    <message>
        <source>the part of the program for pictures of this kind cannot be loaded: %1</source>
        <translation>het deel van het programma voor beelden van dit soort kan niet worden geladen: %1</translation>
    </message>
    <message>
        <source>modelling was cancelled</source>
        <translation>het modelleren is afgebroken</translation>
    </message>
    <message>
        <source>the graphics driver gives no OpenGL context to draw with</source>
        <translation>het grafische stuurprogramma geeft geen OpenGL-context om mee te tekenen</translation>
    </message>
    <message>
        <source>Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>Werk het grafische stuurprogramma bij of stel LIBGL_ALWAYS_SOFTWARE=1 in</translation>
    </message>
    <message>
        <source>does not begin like a NIfTI file</source>
        <translation>begint niet als een NIfTI-bestand</translation>
    </message>
    <message>
        <source>Export it as NIfTI again, or give the file the extension of its kind</source>
        <translation>Exporteer het opnieuw als NIfTI of geef het bestand de extensie van zijn soort</translation>
    </message>
    <message>
        <source>%1 of %2 left/right names contradict the frame %3 that the files give; %4</source>
        <translation>%1 van %2 namen met een zijde spreken het stelsel %3 tegen dat de bestanden opgeven; %4</translation>
    </message>
    <message>
        <source>front and back are right: if the files are mirrored, choose %1</source>
        <translation>voor en achter kloppen: zijn de bestanden gespiegeld, kies dan %1</translation>
    </message>
    <message>
        <source>front and back are swapped too: choose %1</source>
        <translation>ook voor en achter zijn verwisseld: kies %1</translation>
    </message>
    <message>
        <source>if left and right are swapped, choose %1 where front and back are swapped too, else %2</source>
        <translation>zijn links en rechts verwisseld, kies dan %1 waar ook voor en achter verwisseld zijn, anders %2</translation>
    </message>
    <message>
        <source>Give the file one of these endings</source>
        <translation>Geef het bestand een van deze extensies</translation>
    </message>
    <message>
        <source>the sheet would have more than 20000 pixels on a side</source>
        <translation>het blad zou meer dan 20000 pixels aan een kant hebben</translation>
    </message>
    <message>
        <source>its atoms lie too far apart for a lattice between them</source>
        <translation>de atomen liggen te ver uit elkaar voor een rooster ertussen</translation>
    </message>
    <message>
        <source>it has more than %1 atoms</source>
        <translation>het heeft meer dan %1 atomen</translation>
    </message>
    <message>
        <source>Find the pockets of fewer chains at a time</source>
        <translation>Zoek de holten van minder ketens tegelijk</translation>
    </message>
    <message>
        <source>its atoms lie closer together than those of matter do</source>
        <translation>de atomen liggen dichter bij elkaar dan die van materie</translation>
    </message>
    <message>
        <source>Repair the file</source>
        <translation>Herstel het bestand</translation>
    </message>
    <message>
        <source>the large probe must be larger than the small one</source>
        <translation>de grote bol moet groter zijn dan de kleine</translation>
    </message>
    <message>
        <source>panel %1</source>
        <translation>vak %1</translation>
    </message>
    <message>
        <source>panel %1, an inset of %2</source>
        <translation>vak %1, een uitsnede van %2</translation>
    </message>
    <message>
        <source>letters and legend</source>
        <translation>letters en legenda</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is set in %2 pt, and letters smaller than %3 pt are refused</source>
        <translation>“%1” staat in %2 pt, en letters kleiner dan %3 pt worden geweigerd</translation>
    </message>
    <message>
        <source>Make &quot;points&quot; %1 or more, or &quot;least_points&quot; %2</source>
        <translation>Zet “points” op %1 of meer, of “least_points” op %2</translation>
    </message>
    <message>
        <source>it reaches over the page&apos;s edge or into the legend</source>
        <translation>het reikt over de rand van de pagina of in de legenda</translation>
    </message>
    <message>
        <source>Move it, make it smaller or the page larger</source>
        <translation>Verplaats het, maak het kleiner of de pagina groter</translation>
    </message>
    <message>
        <source>it is narrower or lower than 10 mm</source>
        <translation>het is smaller of lager dan 10 mm</translation>
    </message>
    <message>
        <source>Make the page larger, or take fewer columns or rows</source>
        <translation>Maak de pagina groter, of neem minder kolommen of rijen</translation>
    </message>
    <message>
        <source>the part that it shows reaches over the edge of panel %1</source>
        <translation>het deel dat het toont reikt over de rand van vak %1</translation>
    </message>
    <message>
        <source>Move the part, or make it smaller</source>
        <translation>Verplaats het deel, of maak het kleiner</translation>
    </message>
    <message>
        <source>it spans more columns than there are</source>
        <translation>het beslaat meer kolommen dan er zijn</translation>
    </message>
    <message>
        <source>Give the grid more columns</source>
        <translation>Geef het raster meer kolommen</translation>
    </message>
    <message>
        <source>a legend tells colours, and ink alone has none</source>
        <translation>een legenda verklaart kleuren, en inkt alleen heeft er geen</translation>
    </message>
    <message>
        <source>it does not lie in the figure&apos;s folder or below it</source>
        <translation>het ligt niet in de map van de figuur of daaronder</translation>
    </message>
    <message>
        <source>Put the figure&apos;s file beside its scenes</source>
        <translation>Leg het bestand van de figuur naast zijn scènes</translation>
    </message>
    <message>
        <source>the scene has never been saved</source>
        <translation>de scène is nooit opgeslagen</translation>
    </message>
    <message>
        <source>Save it first, so that the figure&apos;s file can name it</source>
        <translation>Sla haar eerst op, zodat het bestand van de figuur haar kan noemen</translation>
    </message>
    <message>
        <source>Leave one of both out</source>
        <translation>Laat een van beide weg</translation>
    </message>
    <message>
        <source>Take fewer pixels to the inch, or a smaller sheet</source>
        <translation>Neem minder pixels per inch of een kleiner blad</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>er is geen map %1</translation>
    </message>
    <message>
        <source>names say that z does not lead to the head: turn the files</source>
        <translation>namen zeggen dat z niet naar het hoofd leidt: draai de bestanden</translation>
    </message>
    <message>
        <source>names of front and back contradict the frame %1; if the files are mirrored, choose %2</source>
        <translation>namen met voor en achter spreken het assenstelsel %1 tegen; kies %2 als de bestanden gespiegeld zijn</translation>
    </message>
    <message>
        <source>surfaces whose files do not say their frame lie beside the others, whether they are read as LPS or as RAS; %1 was assumed</source>
        <translation>oppervlakken waarvan de bestanden hun assenstelsel niet noemen, liggen naast de andere, of ze nu als LPS of als RAS worden gelezen; %1 is aangenomen</translation>
    </message>
    <message>
        <source>scenes of 3D Slicer beside it disagree about its coordinates; none of them was followed</source>
        <translation>scènes van 3D Slicer ernaast zijn het oneens over de coördinaten; geen ervan is gevolgd</translation>
    </message>
    <message>
        <source>%1 of %2 structures are not as large as their names say: &quot;%3&quot; is %4 mm large, and such structures are %5 to %6 mm; %7</source>
        <translation>%1 van de %2 structuren zijn niet zo groot als hun namen zeggen: “%3” is %4 mm groot, en zulke structuren zijn %5 tot %6 mm; %7</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 mm large, and such structures are %3 to %4 mm; %5</source>
        <translation>“%1” is %2 mm groot, en zulke structuren zijn %3 tot %4 mm; %5</translation>
    </message>
    <message>
        <source>no usual unit would make it right</source>
        <translation>geen gebruikelijke eenheid zou het goed maken</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 mm</source>
        <translation>het zou kloppen als de eenheid van het bestand %1 mm was</translation>
    </message>
    <message>
        <source>it would be right if the file&apos;s unit were %1 or %2 mm</source>
        <translation>het zou kloppen als de eenheid van het bestand %1 of %2 mm was</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is flat: it has no extent in a direction</source>
        <translation>“%1” is plat: het heeft in één richting geen omvang</translation>
    </message>
    <message>
        <source>&quot;%1&quot; beside it gives none of its labels a name that is understood</source>
        <translation>“%1” ernaast geeft geen van de labels een naam die wordt begrepen</translation>
    </message>
    <message>
        <source>holds %1 label volumes of one place, as points in time; structures of all of them lie over each other</source>
        <translation>bevat %1 labelvolumes van één plaats, zoals tijdstippen; structuren van alle liggen over elkaar</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units; the sform was taken</source>
        <translation>sform en qform plaatsen het verschillend, tot %1 van zijn eenheden uit elkaar; de sform is genomen</translation>
    </message>
    <message>
        <source>sform and qform place it differently, by up to %1 of its units and with left and right swapped; the sform was taken</source>
        <translation>sform en qform plaatsen het verschillend, tot %1 van zijn eenheden uit elkaar en met links en rechts verwisseld; de sform is genomen</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as the file says</source>
        <translation>is op één snede getekend; %1 mm dik gemaakt, zoals het bestand zegt</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, as slices of other structures are</source>
        <translation>is op één snede getekend; %1 mm dik gemaakt, zoals sneden van andere structuren</translation>
    </message>
    <message>
        <source>is drawn on one slice; made %1 mm thick, which nothing tells</source>
        <translation>is op één snede getekend; %1 mm dik gemaakt, wat niets aangeeft</translation>
    </message>
    <message>
        <source>is of another patient than the files before it; left out</source>
        <translation>is van een andere patiënt dan de bestanden ervoor; weggelaten</translation>
    </message>
    <message>
        <source>files of one patient lie in different frames of reference: nothing says that what is laid over each other fits</source>
        <translation>bestanden van één patiënt liggen in verschillende referentiestelsels: niets zegt dat past wat over elkaar ligt</translation>
    </message>
    <message>
        <source>it is of another patient than the other files now</source>
        <translation>het is nu van een andere patiënt dan de andere bestanden</translation>
    </message>
    <message>
        <source>it lies more than 100 km from the origin</source>
        <translation>het ligt meer dan 100 km van de oorsprong</translation>
    </message>
    <message>
        <source>Check the unit of its coordinates</source>
        <translation>Controleer de eenheid van de coördinaten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across: an implausible size, check the unit</source>
        <translation>“%1” meet %2: een onwaarschijnlijke grootte, controleer de eenheid</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 other is as unlikely: an implausible size, check the unit</source>
        <translation>“%1” meet %2, en %3 andere is even onwaarschijnlijk: controleer de eenheid</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 across, and %3 others are as unlikely: an implausible size, check the unit</source>
        <translation>“%1” meet %2, en %3 andere zijn even onwaarschijnlijk: controleer de eenheid</translation>
    </message>
    <message>
        <source>eye or target lies more than 100,000 km away</source>
        <translation>oog of doel ligt meer dan 100.000 km ver weg</translation>
    </message>
    <message>
        <source>the height is too small or too large for where eye and target lie</source>
        <translation>de hoogte is te klein of te groot voor de plaats van oog en doel</translation>
    </message>
    <message>
        <source>weak vote: %1 of %2 left/right names</source>
        <translation>zwakke stemming: %1 van %2 namen met links/rechts</translation>
    </message>
    <message>
        <source>names of front and back alone</source>
        <translation>alleen namen met voor en achter</translation>
    </message>
    <message>
        <source>laid over surfaces of the same names: %1 within 2 mm</source>
        <translation>over oppervlakken met dezelfde naam gelegd: %1 binnen 2 mm</translation>
    </message>
    <message>
        <source>fits in with the other surfaces</source>
        <translation>past bij de andere oppervlakken</translation>
    </message>
    <message>
        <source>confirmed by hand</source>
        <translation>met de hand bevestigd</translation>
    </message>
    <message>
        <source>mirrored by hand</source>
        <translation>met de hand gespiegeld</translation>
    </message>
    <message>
        <source>turned by hand</source>
        <translation>met de hand gedraaid</translation>
    </message>
    <message>
        <source>%1; sizes are not those of what is named</source>
        <translation>%1; de afmetingen zijn niet die van wat er genoemd wordt</translation>
    </message>
    <message>
        <source>the program held %1 bytes for %2×%3 pixels of the picture, which is not what they take</source>
        <translation>het programma had %1 bytes voor %2×%3 pixels van de afbeelding, en dat is niet wat die nodig hebben</translation>
    </message>
    <message>
        <source>Save the scene and start the program again</source>
        <translation>Sla de scène op en start het programma opnieuw</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;: %2</source>
        <translation>Structuur “%1”: %2</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;: %2</source>
        <translation>Groep “%1”: %2</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;: %2</source>
        <translation>Aanzicht “%1”: %2</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;: %2</source>
        <translation>Label “%1”: %2</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;: %2</source>
        <translation>Scan “%1”: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;</source>
        <translation>Structuur “%1”</translation>
    </message>
    <message>
        <source>group &quot;%1&quot;</source>
        <translation>Groep “%1”</translation>
    </message>
    <message>
        <source>view &quot;%1&quot;</source>
        <translation>Aanzicht “%1”</translation>
    </message>
    <message>
        <source>label &quot;%1&quot;</source>
        <translation>Label “%1”</translation>
    </message>
    <message>
        <source>scan &quot;%1&quot;</source>
        <translation>Scan “%1”</translation>
    </message>
    <message>
        <source>%1; it was cut there</source>
        <translation>%1; daar is het afgekapt</translation>
    </message>
    <message>
        <source>%1; it was left out</source>
        <translation>%1; het is weggelaten</translation>
    </message>
    <message>
        <source>%1; they became signs for unknown letters</source>
        <translation>%1; ze werden tekens voor onbekende letters</translation>
    </message>
    <message>
        <source>%1; the rest was left out</source>
        <translation>%1; de rest is weggelaten</translation>
    </message>
    <message>
        <source>%1; the section was left out</source>
        <translation>%1; de doorsnede is weggelaten</translation>
    </message>
    <message>
        <source>%1; the atoms were left out</source>
        <translation>%1; de atomen zijn weggelaten</translation>
    </message>
    <message>
        <source>%1; what is in it went to the group above</source>
        <translation>%1; wat erin zit, ging naar de groep erboven</translation>
    </message>
    <message>
        <source>the name is longer than %1 bytes</source>
        <translation>de naam is langer dan %1 bytes</translation>
    </message>
    <message>
        <source>the text is longer than %1 bytes</source>
        <translation>de tekst is langer dan %1 bytes</translation>
    </message>
    <message>
        <source>a text is longer than %1 bytes</source>
        <translation>een tekst is langer dan %1 bytes</translation>
    </message>
    <message>
        <source>its credit is longer than %1 bytes</source>
        <translation>de bronvermelding is langer dan %1 bytes</translation>
    </message>
    <message>
        <source>%1 is longer than %2 bytes</source>
        <translation>%1 is langer dan %2 bytes</translation>
    </message>
    <message>
        <source>the name has bytes that are no letters in UTF-8</source>
        <translation>de naam heeft bytes die in UTF-8 geen tekens zijn</translation>
    </message>
    <message>
        <source>%1 has bytes that are no letters in UTF-8</source>
        <translation>%1 heeft bytes die in UTF-8 geen tekens zijn</translation>
    </message>
    <message>
        <source>%1 is in more than %2 languages</source>
        <translation>%1 staat in meer dan %2 talen</translation>
    </message>
    <message>
        <source>%1 is in a language that has no name</source>
        <translation>%1 staat in een taal zonder naam</translation>
    </message>
    <message>
        <source>%1 is no finite number</source>
        <translation>%1 is geen eindig getal</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>de waarde van %1 ligt buiten de grenzen</translation>
    </message>
    <message>
        <source>the time is out of range</source>
        <translation>de tijd ligt buiten de grenzen</translation>
    </message>
    <message>
        <source>it lies more than %1 groups deep</source>
        <translation>hij ligt meer dan %1 groepen diep</translation>
    </message>
    <message>
        <source>it is on a triangle that no structure of the scene has</source>
        <translation>het wijst naar een driehoek die geen structuur van de scène heeft</translation>
    </message>
    <message>
        <source>what is painted on it is of another surface</source>
        <translation>wat erop geschilderd is, hoort bij een ander oppervlak</translation>
    </message>
    <message>
        <source>an atom lies nowhere, or there are too many</source>
        <translation>een atoom ligt nergens, of het zijn er te veel</translation>
    </message>
    <message>
        <source>a scene holds no more than %1 %2, and these would be %3</source>
        <translation>een scène bevat hoogstens %1 %2, en dit zouden er %3 zijn</translation>
    </message>
    <message>
        <source>structures and groups</source>
        <translation>structuren en groepen</translation>
    </message>
    <message>
        <source>Take fewer of them into one scene</source>
        <translation>Neem er minder van in één scène</translation>
    </message>
    <message>
        <source>Change it so that a scene file can keep it</source>
        <translation>Verander het zo dat een scènebestand het kan bewaren</translation>
    </message>
    <message>
        <source>Undo what brought it into the scene, and save again</source>
        <translation>Maak ongedaan wat het in de scène bracht en sla opnieuw op</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file</source>
        <translation>de scène is te groot voor een scènebestand</translation>
    </message>
    <message>
        <source>the scene is too large for a scene file: %1</source>
        <translation>de scène is te groot voor een scènebestand: %1</translation>
    </message>
    <message>
        <source>Save fewer views, or fewer structures in one scene</source>
        <translation>Bewaar minder aanzichten of minder structuren in één scène</translation>
    </message>
    <message>
        <source>Put fewer structures or scans into one scene</source>
        <translation>Doe minder structuren of scans in één scène</translation>
    </message>
    <message>
        <source>something in it is at fault and not in the scene; it would be lost</source>
        <translation>iets erin is fout en niet in de scène; het zou verloren gaan</translation>
    </message>
    <message>
        <source>something in it is at fault: %1</source>
        <translation>iets erin is fout: %1</translation>
    </message>
    <message>
        <source>Open it by itself and save it under another name</source>
        <translation>Open het apart en sla het op onder een andere naam</translation>
    </message>
    <message>
        <source>something in it is at fault and was left out (%1); the file stays as it is, and the scene can only be saved under another name</source>
        <translation>iets erin is fout en is weggelaten (%1); het bestand blijft zoals het is, en de scène kan alleen onder een andere naam worden opgeslagen</translation>
    </message>
    <message>
        <source>a newer version of the program has written it (schema %1, known here: %2); what is unknown is not shown, and it can only be saved under another name, as schema %3</source>
        <translation>een nieuwere versie van het programma heeft het geschreven (schema %1, hier bekend: %2); wat onbekend is, wordt niet getoond, en het kan alleen onder een andere naam worden opgeslagen, als schema %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; (%2): %3</source>
        <translation>“%1” (%2): %3</translation>
    </message>
    <message>
        <source>a number from %1 to %2 is expected here</source>
        <translation>hier wordt een getal van %1 tot %2 verwacht</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2 is expected here</source>
        <translation>hier wordt een geheel getal van %1 tot %2 verwacht</translation>
    </message>
    <message>
        <source>a text is expected here</source>
        <translation>hier wordt een tekst verwacht</translation>
    </message>
    <message>
        <source>a number is expected here</source>
        <translation>hier wordt een getal verwacht</translation>
    </message>
    <message>
        <source>true or false is expected here</source>
        <translation>hier wordt true of false verwacht</translation>
    </message>
    <message>
        <source>a list is expected here</source>
        <translation>hier wordt een lijst verwacht</translation>
    </message>
    <message>
        <source>an object is expected here</source>
        <translation>hier wordt een object verwacht</translation>
    </message>
    <message>
        <source>a line of at most %1 bytes is expected here</source>
        <translation>hier wordt een regel van hoogstens %1 bytes verwacht</translation>
    </message>
    <message>
        <source>a colour as &quot;#rrggbb&quot; is expected here</source>
        <translation>hier wordt een kleur als “#rrggbb” verwacht</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or another word of this format is expected here</source>
        <translation>hier wordt “%1” of een ander woord van dit formaat verwacht</translation>
    </message>
    <message>
        <source>the file holds no such mesh</source>
        <translation>het bestand bevat geen zo’n net</translation>
    </message>
    <message>
        <source>it is no mesh of this format</source>
        <translation>het is geen net van dit formaat</translation>
    </message>
    <message>
        <source>%1; the structure stays as an empty row</source>
        <translation>%1; de structuur blijft als lege rij staan</translation>
    </message>
    <message>
        <source>the file holds no such paint</source>
        <translation>het bestand bevat geen zo’n beschildering</translation>
    </message>
    <message>
        <source>it does not begin like what is painted on a mesh</source>
        <translation>het begint niet zoals wat op een net is geschilderd</translation>
    </message>
    <message>
        <source>it does not begin like the voxels of a scan</source>
        <translation>het begint niet zoals de voxels van een scan</translation>
    </message>
    <message>
        <source>its unit is stated (%1) and was followed</source>
        <translation>de eenheid is opgegeven (%1) en werd gevolgd</translation>
    </message>
    <message>
        <source>%1 lies on the other side than its name says</source>
        <translation>%1 ligt aan de andere kant dan de naam zegt</translation>
    </message>
    <message>
        <source>%1 lie on the other side than their names say</source>
        <translation>%1 liggen aan de andere kant dan hun namen zeggen</translation>
    </message>
    <message>
        <source>molecules are drawn with 1 Å as 1 mm, ten million times as large as &quot;%1&quot; beside them; no scale bar holds for both, so open them apart</source>
        <translation>moleculen zijn getekend met 1 Å als 1 mm, tien miljoen keer zo groot als ‘%1’ ernaast; geen schaalbalk geldt voor beide, open ze dus apart</translation>
    </message>
    <message>
        <source>SlicerRT&apos;s segmentations are RAS</source>
        <translation>segmentaties van SlicerRT zijn RAS</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, which are not as many as it has; it was placed as if its origin were its own</source>
        <translation>zegt dat het de voxels %1 van een referentiebeeld bevat, en dat zijn er niet zoveel als het heeft; het werd geplaatst alsof de oorsprong van hemzelf was</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image, and an offset in it, as files with an origin of their own do; it was placed by its origin alone</source>
        <translation>noemt de voxels %1 van een referentiebeeld en een verschuiving daarin, zoals bestanden met een eigen oorsprong doen; het werd alleen op zijn oorsprong geplaatst</translation>
    </message>
    <message>
        <source>the files are of %1 patients: %2</source>
        <translation>de bestanden zijn van %1 patiënten: %2</translation>
    </message>
    <message>
        <source>the files are of %1 studies, and nothing says that they are of one patient: %2</source>
        <translation>de bestanden zijn van %1 onderzoeken, en niets zegt dat ze van één patiënt zijn: %2</translation>
    </message>
    <message>
        <source>Give the files of one patient, or put them together on purpose</source>
        <translation>Geef de bestanden van één patiënt, of voeg ze met opzet samen</translation>
    </message>
    <message>
        <source>it came from more than %1 studies</source>
        <translation>ze kwam uit meer dan %1 onderzoeken</translation>
    </message>
    <message>
        <source>what was there already is read as %1 now: %2</source>
        <translation>wat er al was, wordt nu als %1 gelezen: %2</translation>
    </message>
    <message>
        <source>left and right of what was there already are certain now: %1</source>
        <translation>links en rechts van wat er al was, zijn nu zeker: %1</translation>
    </message>
    <message>
        <source>is a scan rather than a label volume: %1</source>
        <translation>is een scan en geen labelvolume: %1</translation>
    </message>
    <message>
        <source>Give a threshold that makes a structure of it, or choose the segmentation that was made of it</source>
        <translation>Geef een drempel die er een structuur van maakt, of kies de segmentatie die ervan gemaakt is</translation>
    </message>
    <message>
        <source>Structures come from a DICOM segmentation or RT structure set, from label maps and meshes made of the images, or from a threshold</source>
        <translation>Structuren komen uit een DICOM-segmentatie of RT-structurenset, uit labelkaarten en netten die van de beelden gemaakt zijn, of van een drempel</translation>
    </message>
    <message>
        <source>Name one of the scene&apos;s saved views</source>
        <translation>Noem een van de bewaarde aanzichten van de scène</translation>
    </message>
    <message>
        <source>Change it in the figure&apos;s file</source>
        <translation>Verander het in het bestand van de figuur</translation>
    </message>
    <message>
        <source>a comparison sheet is a pdf, svg, png or tiff file</source>
        <translation>een vergelijkingsblad is een pdf-, svg-, png- of tiff-bestand</translation>
    </message>
    <message>
        <source>a figure is a pdf, svg, png or tiff file</source>
        <translation>een figuur is een pdf-, svg-, png- of tiff-bestand</translation>
    </message>
    <message>
        <source>a depth of 1 bit leaves black and white alone, and the figure has tones</source>
        <translation>een diepte van 1 bit laat alleen zwart en wit over, en de figuur heeft tinten</translation>
    </message>
    <message>
        <source>Let the figure be black and white, or take 8 bits</source>
        <translation>Maak de figuur zwart-wit, of neem 8 bits</translation>
    </message>
    <message>
        <source>names of sides in this folder contradict the frame of the others, %1; it was taken, and is not certain here</source>
        <translation>namen van zijden in deze map spreken het assenstelsel van de andere tegen, %1; het werd genomen en is hier niet zeker</translation>
    </message>
    <message>
        <source>the files of this folder are read as %1, unlike others: %2</source>
        <translation>de bestanden van deze map worden anders dan andere als %1 gelezen: %2</translation>
    </message>
    <message>
        <source>says that it holds the voxels %1 of a reference image; its origin was taken to be that image&apos;s</source>
        <translation>zegt dat het de voxels %1 van een referentiebeeld bevat; de oorsprong werd als die van dat beeld genomen</translation>
    </message>
    <message>
        <source>Save it as a scene file, and name it with its ending .sline</source>
        <translation>Bewaar het als scènebestand, en noem het met zijn uitgang .sline</translation>
    </message>
    <message>
        <source>words and numbers of no anatomy, maybe a person&apos;s, left out of names: %1</source>
        <translation>in namen weggelaten woorden en getallen die niet bij de anatomie horen, maar bij een persoon kunnen horen; aantal namen: %1</translation>
    </message>
    <message>
        <source>there is no such member in the file</source>
        <translation>het bestand bevat geen zo’n onderdeel</translation>
    </message>
    <message>
        <source>the graphics driver has lost what it had drawn</source>
        <translation>het grafische stuurprogramma is kwijt wat het had getekend</translation>
    </message>
    <message>
        <source>the graphics driver has no memory left for the picture</source>
        <translation>het grafische stuurprogramma heeft geen geheugen meer voor het beeld</translation>
    </message>
    <message>
        <source>the names of the files tell of %1 bodies: %2</source>
        <translation>de namen van de bestanden wijzen op %1 lichamen: %2</translation>
    </message>
    <message>
        <source>another file of this name is not as it was read; name its folder if that one is meant</source>
        <translation>een ander bestand met deze naam is niet zoals het gelezen werd; noem de map ervan als dat bedoeld is</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2 large now and was %3: its file may have another unit</source>
        <translation>“%1” is nu %2 groot en was %3: het bestand kan een andere eenheid hebben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies %2 away from where it was: it may be another body&apos;s, or mirrored</source>
        <translation>“%1” ligt %2 van de plaats waar het was: het kan van een ander lichaam zijn, of gespiegeld</translation>
    </message>
</context>
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
    <message>
        <source>Opens a scene that the program models itself: %1.</source>
        <translation>Opent een scène die het programma zelf modelleert: %1.</translation>
    </message>
    <message>
        <source>Opens a window of its own, whatever the preferences say of files from outside.</source>
        <translation>Opent een eigen venster, wat de voorkeuren ook zeggen over bestanden van buiten.</translation>
    </message>
</context>
<context>
    <name>sline::render::ExportFormat</name>
    <message>
        <source>Vectors for Inkscape, Illustrator and print: lines and hatching as smooth paths, hidden ones removed, a named group for each structure</source>
        <translation>Vectoren voor Inkscape, Illustrator en druk: lijnen en arcering als vloeiende paden, zonder verborgen lijnen, een benoemde groep per structuur</translation>
    </message>
    <message>
        <source>A picture made of pixels for screens, documents and print: sRGB, grey or pure ink, 8 or 16 bits, transparent where asked for</source>
        <translation>Een afbeelding van pixels voor scherm, documenten en druk: sRGB, grijs of zuivere inkt, 8 of 16 bits, desgewenst doorzichtig</translation>
    </message>
    <message>
        <source>The same for printers and journals, with its colour profile</source>
        <translation>Hetzelfde voor drukkers en tijdschriften, met kleurprofiel</translation>
    </message>
    <message>
        <source>A picture made of pixels where files must be small; on white</source>
        <translation>Een afbeelding van pixels waar bestanden klein moeten zijn; op wit</translation>
    </message>
    <message>
        <source>A picture in linear light, as halves with alpha multiplied in, for compositing</source>
        <translation>Een afbeelding in lineair licht, halve precisie, met alfa ingerekend, voor compositie</translation>
    </message>
    <message>
        <source>Surfaces for Blender, PowerPoint, web pages and headsets: groups, names and colours, annotations, cameras of the saved views</source>
        <translation>Oppervlakken voor Blender, PowerPoint, webpagina’s en brillen: groepen, namen en kleuren, labels, camera’s van de bewaarde aanzichten</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4-film</translation>
    </message>
    <message>
        <source>A film for slides and web pages, where the program ffmpeg is installed</source>
        <translation>Een film voor dia’s en webpagina’s, waar het programma ffmpeg geïnstalleerd is</translation>
    </message>
    <message>
        <source>Animated WebP</source>
        <translation>Bewegende WebP</translation>
    </message>
    <message>
        <source>A film that browsers show as a picture</source>
        <translation>Een film die browsers als afbeelding tonen</translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation>Bewegende GIF</translation>
    </message>
    <message>
        <source>A film that every program shows, of at most 255 colours: small ones</source>
        <translation>Een film die elk programma toont, met hoogstens 255 kleuren: voor kleine</translation>
    </message>
    <message>
        <source>Frames of a film</source>
        <translation>Beelden van een film</translation>
    </message>
    <message>
        <source>A new folder of numbered PNG pictures, for programs that cut films</source>
        <translation>Een nieuwe map met genummerde PNG-afbeeldingen, voor montageprogramma’s</translation>
    </message>
    <message>
        <source>Anki deck</source>
        <translation>Anki-stapel</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-afbeelding</translation>
    </message>
    <message>
        <source>TIFF picture</source>
        <translation>TIFF-afbeelding</translation>
    </message>
    <message>
        <source>JPEG picture</source>
        <translation>JPEG-afbeelding</translation>
    </message>
    <message>
        <source>EXR picture</source>
        <translation>EXR-afbeelding</translation>
    </message>
    <message>
        <source>WebP picture</source>
        <translation>WebP-afbeelding</translation>
    </message>
    <message>
        <source>A picture for web pages, smaller than PNG and as exact: 8 bits in colour</source>
        <translation>Een afbeelding voor webpagina&apos;s, kleiner dan PNG en even exact: 8 bits in kleur</translation>
    </message>
    <message>
        <source>JPEG 2000 picture</source>
        <translation>JPEG 2000-afbeelding</translation>
    </message>
    <message>
        <source>A picture for archives that ask for it, exact: 8 or 16 bits</source>
        <translation>Een afbeelding voor archieven die erom vragen, exact: 8 of 16 bits</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-tekening</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-document</translation>
    </message>
    <message>
        <source>GLB surfaces (glTF)</source>
        <translation>GLB-oppervlakken (glTF)</translation>
    </message>
    <message>
        <source>PowerPoint slides</source>
        <translation>PowerPoint-dia&apos;s</translation>
    </message>
    <message>
        <source>A slide for each saved view with its title, text and notes: labels are text boxes and lines that can be edited there, over the drawing</source>
        <translation>Een dia voor elk bewaard aanzicht met titel, tekst en notities: labels zijn tekstvakken en lijnen boven de tekening, die daar te bewerken zijn</translation>
    </message>
    <message>
        <source>The same vectors on a page of their own, or a sheet with title, legend and numbered labels, a page to test oneself and its key; of all saved views with contents and an index</source>
        <translation>Dezelfde vectoren op een eigen pagina, of een blad met titel, legenda en genummerde benamingen, een pagina om zichzelf te toetsen en de antwoorden; van alle bewaarde aanzichten met inhoud en register</translation>
    </message>
    <message>
        <source>Cards that ask for the labels of the picture, or of all saved views: a package for Anki (.apkg), or text and pictures in a ZIP (.zip) or a new folder</source>
        <translation>Kaarten die naar de benamingen van de afbeelding of van alle bewaarde aanzichten vragen: een pakket voor Anki (.apkg), of tekst en afbeeldingen in een ZIP (.zip) of een nieuwe map</translation>
    </message>
    <message>
        <source>For students (HTML page)</source>
        <translation>Voor studenten (HTML-pagina)</translation>
    </message>
    <message>
        <source>One file for any browser, also offline and on telephones: the scene to turn, with its tree, labels, saved views as a tour, and a quiz</source>
        <translation>Eén bestand voor elke browser, ook zonder net en op telefoons: de scène om te draaien, met haar boom, labels, bewaarde aanzichten als rondleiding en een quiz</translation>
    </message>
    <message>
        <source>For students (web site)</source>
        <translation>Voor studenten (website)</translation>
    </message>
    <message>
        <source>The same page as a new folder of files for a web server, most of which are the same for every scene; browsers do not open it from a disk</source>
        <translation>Dezelfde pagina als een nieuwe map met bestanden voor een webserver, waarvan de meeste voor elke scène gelijk zijn; browsers openen haar niet vanaf een schijf</translation>
    </message>
    <message>
        <source>Moodle questions</source>
        <translation>Moodle-vragen</translation>
    </message>
    <message>
        <source>Questions with pictures, made of the labels, as XML for a question bank: markers to be put in place, names to be typed or chosen</source>
        <translation>Vragen met afbeeldingen, gemaakt van de labels, als XML voor een vragenbank: markeringen die op hun plaats komen, namen om te typen of te kiezen</translation>
    </message>
    <message>
        <source>QTI questions</source>
        <translation>QTI-vragen</translation>
    </message>
    <message>
        <source>The same for other question banks and examination systems, as a package of QTI 2.1</source>
        <translation>Hetzelfde voor andere vragenbanken en toetssystemen, als pakket van QTI 2.1</translation>
    </message>
    <message>
        <source>H5P questions</source>
        <translation>H5P-vragen</translation>
    </message>
    <message>
        <source>The same as content for H5P, to be played where its content types are installed</source>
        <translation>Hetzelfde als inhoud voor H5P, af te spelen waar de inhoudstypen ervan zijn geïnstalleerd</translation>
    </message>
    <message>
        <source>SCORM 1.2 package</source>
        <translation>SCORM 1.2-pakket</translation>
    </message>
    <message>
        <source>The page for students in a package that tells a learning system each answer and the score, by the standard that most systems know</source>
        <translation>De pagina voor studenten in een pakket dat een leeromgeving elk antwoord en de score meldt, volgens de standaard die de meeste kennen</translation>
    </message>
    <message>
        <source>SCORM 2004 package</source>
        <translation>SCORM 2004-pakket</translation>
    </message>
    <message>
        <source>The same by SCORM 2004, 4th edition</source>
        <translation>Hetzelfde volgens SCORM 2004, 4e editie</translation>
    </message>
    <message>
        <source>cmi5 package</source>
        <translation>cmi5-pakket</translation>
    </message>
    <message>
        <source>The same by cmi5, for systems with a learning record store</source>
        <translation>Hetzelfde volgens cmi5, voor omgevingen met een learning record store</translation>
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
        <translation>De naam in Anki; anders de naam van het aanzicht</translation>
    </message>
    <message>
        <source>Once around</source>
        <translation>Eén keer rond</translation>
    </message>
    <message>
        <source>From view to view</source>
        <translation>Van aanzicht naar aanzicht</translation>
    </message>
    <message>
        <source>Γ from 0 to 5</source>
        <translation>Γ van 0 tot 5</translation>
    </message>
    <message>
        <source>Len&amp;gth</source>
        <translation>&amp;Duur</translation>
    </message>
    <message>
        <source>Of the whole film</source>
        <translation>Van de hele film</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Pictures a secon&amp;d</source>
        <translation>Bee&amp;lden per seconde</translation>
    </message>
    <message>
        <source>More are smoother, and more to draw</source>
        <translation>Meer is vloeiender, en meer te tekenen</translation>
    </message>
    <message>
        <source>Height of the film</source>
        <translation>Hoogte van de film</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>Be&amp;weging</translation>
    </message>
    <message>
        <source>What moves in the film</source>
        <translation>Wat in de film beweegt</translation>
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
        <source>Dark</source>
        <translation>Donker</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Doorzichtig</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Teksten</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nummers</translation>
    </message>
    <message>
        <source>Blank lines, for a test</source>
        <translation>Lege regels, voor een toets</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Labels</translation>
    </message>
    <message>
        <source>How the scene&apos;s labels stand in the picture</source>
        <translation>Hoe de labels van de scène in de afbeelding staan</translation>
    </message>
    <message>
        <source>Le&amp;tters</source>
        <translation>Le&amp;tters</translation>
    </message>
    <message>
        <source>How large the letters of labels are on paper</source>
        <translation>Hoe groot de letters van labels op papier zijn</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message>
        <source>&amp;Right and left</source>
        <translation>&amp;Rechts en links</translation>
    </message>
    <message>
        <source>R and L, and the body&apos;s other directions</source>
        <translation>R en L en de andere richtingen van het lichaam</translation>
    </message>
    <message>
        <source>&amp;Name of the view</source>
        <translation>&amp;Naam van het aanzicht</translation>
    </message>
    <message>
        <source>“Anterior view”, or the saved view&apos;s name</source>
        <translation>“Vooraanzicht”, of de naam van het bewaarde aanzicht</translation>
    </message>
    <message>
        <source>S&amp;cale bar</source>
        <translation>S&amp;chaalbalk</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Hoe lang een centimeter is</translation>
    </message>
    <message>
        <source>S&amp;ections</source>
        <translation>Doorsn&amp;eden</translation>
    </message>
    <message>
        <source>What sections have taken away</source>
        <translation>Wat doorsneden hebben weggenomen</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Maker</translation>
    </message>
    <message>
        <source>Written into the file, which says of nobody who made it where this is empty</source>
        <translation>Komt in het bestand; blijft het leeg, dan staat er niet in wie het gemaakt heeft</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Rechten</translation>
    </message>
    <message>
        <source>Whose it is or what others may do with it, as in “CC BY 4.0”</source>
        <translation>Van wie het is of wat anderen ermee mogen doen, zoals “CC BY 4.0”</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>Achter&amp;grond</translation>
    </message>
    <message>
        <source>What lies behind the drawing</source>
        <translation>Wat achter de tekening ligt</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Taal</translation>
    </message>
    <message>
        <source>Of texts and numbers; where a label has no text in it, the scene&apos;s own</source>
        <translation>Van teksten en getallen; waar een label er geen tekst in heeft, die van de scène</translation>
    </message>
    <message>
        <source>Black in&amp;k alone</source>
        <translation>Alleen &amp;zwarte inkt</translation>
    </message>
    <message>
        <source>For print without tones: each pixel is ink or paper; what is shaded is hatched instead</source>
        <translation>Voor druk zonder tonen: elke pixel is inkt of papier; schaduw wordt arcering</translation>
    </message>
    <message>
        <source>The figure alone</source>
        <translation>Alleen de figuur</translation>
    </message>
    <message>
        <source>With title and legend</source>
        <translation>Met titel en legenda</translation>
    </message>
    <message>
        <source>For teaching, with self-test</source>
        <translation>Voor onderwijs, met zelftoets</translation>
    </message>
    <message>
        <source>For a patient</source>
        <translation>Voor een patiënt</translation>
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
        <translation>Papier van het blad</translation>
    </message>
    <message>
        <source>Of sheets alone</source>
        <translation>Alleen van bladen</translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation>T&amp;itel</translation>
    </message>
    <message>
        <source>At the head of a sheet</source>
        <translation>Boven aan een blad</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Tekst</translation>
    </message>
    <message>
        <source>Of a sheet for a patient; each line is a paragraph</source>
        <translation>Van een blad voor een patiënt; elke regel is een alinea</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Liggend</translation>
    </message>
    <message>
        <source>Wider than high</source>
        <translation>Breder dan hoog</translation>
    </message>
    <message>
        <source>Shee&amp;t</source>
        <translation>B&amp;lad</translation>
    </message>
    <message>
        <source>The page around the figure, of a paper of its own</source>
        <translation>De pagina om de figuur, op eigen papier</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Diepte</translation>
    </message>
    <message>
        <source>Of each colour; 16 bits for work that follows</source>
        <translation>Van elke kleur; 16 bits om verder te bewerken</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grijs</translation>
    </message>
    <message>
        <source>Without colours, with a grey profile</source>
        <translation>Zonder kleuren, met grijsprofiel</translation>
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
        <translation>1080 × 1080, vierkant</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Een andere grootte</translation>
    </message>
    <message>
        <source>The page&apos;s shape</source>
        <translation>De vorm van de pagina</translation>
    </message>
    <message>
        <source>Width and height in pixels</source>
        <translation>Breedte en hoogte in pixels</translation>
    </message>
    <message>
        <source>Width of the film</source>
        <translation>Breedte van de film</translation>
    </message>
    <message>
        <source>Of another size</source>
        <translation>Bij een andere grootte</translation>
    </message>
    <message>
        <source>Of another size, or of the page&apos;s shape</source>
        <translation>Bij een andere grootte of de vorm van de pagina</translation>
    </message>
    <message>
        <source>On sheets alone</source>
        <translation>Alleen op bladen</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle structuren</translation>
    </message>
    <message>
        <source>Those with a label</source>
        <translation>Die met een label</translation>
    </message>
    <message>
        <source>Those in focus</source>
        <translation>Die in focus</translation>
    </message>
    <message>
        <source>Colours and names, in the picture&apos;s corner or on the sheet</source>
        <translation>Kleuren en namen, in de hoek van het beeld of op het blad</translation>
    </message>
    <message>
        <source>Size of the film</source>
        <translation>Grootte van de film</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legenda</translation>
    </message>
    <message>
        <source>Γ over s&amp;urfaces</source>
        <translation>Γ over opper&amp;vlakken</translation>
    </message>
    <message>
        <source>By what Γ varies, and how the drawing changes along it</source>
        <translation>Waarnaar Γ varieert, en hoe de tekening daarlangs verandert</translation>
    </message>
    <message>
        <source>Su&amp;btitle file</source>
        <translation>Onder&amp;titelbestand</translation>
    </message>
    <message>
        <source>What the views say as a WebVTT file beside the film, for players and web pages</source>
        <translation>Wat de aanzichten zeggen als WebVTT-bestand naast de film, voor spelers en webpagina’s</translation>
    </message>
    <message>
        <source>Text of the &amp;view</source>
        <translation>Te&amp;kst van het aanzicht</translation>
    </message>
    <message>
        <source>Title and text of a saved view at the picture&apos;s foot, where it says any; in films as a subtitle</source>
        <translation>Titel en tekst van een bewaard aanzicht onder aan de afbeelding, waar het die heeft; in films als ondertitel</translation>
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
        <translation>Vorm van dia&apos;s</translation>
    </message>
    <message>
        <source>Width and height of a slide</source>
        <translation>Breedte en hoogte van een dia</translation>
    </message>
    <message>
        <source>Labels by clicks</source>
        <translation>Labels per klik</translation>
    </message>
    <message>
        <source>Labels appear one by one, each with a click, in the scene&apos;s order</source>
        <translation>Labels verschijnen een voor een, elk met een klik, in de volgorde van de scène</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Zelftest</translation>
    </message>
    <message>
        <source>After each slide one with numbers in place of its labels, and then the key</source>
        <translation>Na elke dia een met nummers in plaats van de labels, en dan de antwoorden</translation>
    </message>
    <message>
        <source>Which number is it?</source>
        <translation>Welk nummer is het?</translation>
    </message>
    <message>
        <source>A card for each name, which asks for its number in the picture</source>
        <translation>Een kaart voor elke naam, die naar het nummer in de afbeelding vraagt</translation>
    </message>
    <message>
        <source>Which name is covered?</source>
        <translation>Welke naam is bedekt?</translation>
    </message>
    <message>
        <source>A card for each label, which covers its name among the others</source>
        <translation>Een kaart voor elke benaming, die de naam tussen de andere bedekt</translation>
    </message>
    <message>
        <source>What is this?</source>
        <translation>Wat is dit?</translation>
    </message>
    <message>
        <source>A card for each label, which marks the place and asks what it is</source>
        <translation>Een kaart voor elke benaming, die de plaats markeert en vraagt wat het is</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschrijving</translation>
    </message>
    <message>
        <source>What the picture shows, for who does not see it; where this is empty, the file says what is seen in the picture, and “off” leaves it out</source>
        <translation>Wat de afbeelding toont, voor wie haar niet ziet; is dit leeg, dan zegt het bestand wat er te zien is, en “off” laat het weg</translation>
    </message>
    <message>
        <source>Beside surfaces alone</source>
        <translation>Alleen bij oppervlakken</translation>
    </message>
    <message>
        <source>In a line</source>
        <translation>Op één regel</translation>
    </message>
    <message>
        <source>On a page of their own</source>
        <translation>Op een eigen pagina</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Nergens</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Bronnen</translation>
    </message>
    <message>
        <source>Whose work the surfaces are and under what terms</source>
        <translation>Wiens werk de oppervlakken zijn en onder welke voorwaarden</translation>
    </message>
    <message>
        <source>All with a label</source>
        <translation>Alles met benaming</translation>
    </message>
    <message>
        <source>Test asks for</source>
        <translation>Toets vraagt naar</translation>
    </message>
    <message>
        <source>The fewer, the easier</source>
        <translation>Hoe minder, hoe makkelijker</translation>
    </message>
    <message>
        <source>Of these alone</source>
        <translation>Alleen hiervan</translation>
    </message>
    <message>
        <source>Names of structures or groups, with commas; empty: of all</source>
        <translation>Namen van structuren of groepen, met komma’s; leeg: van alle</translation>
    </message>
    <message>
        <source>&amp;Callouts, too</source>
        <translation>Ook te&amp;kstvakken</translation>
    </message>
    <message>
        <source>Callouts explain; only labels name what can be asked for</source>
        <translation>Tekstvakken leggen uit; alleen benamingen noemen waarnaar men kan vragen</translation>
    </message>
    <message>
        <source>After each test</source>
        <translation>Na elke toets</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Aan het eind</translation>
    </message>
    <message>
        <source>Word bank</source>
        <translation>Woordenlijst</translation>
    </message>
    <message>
        <source>The self-test has the answers below, in another order</source>
        <translation>Onder de zelftoets staan de antwoorden in een andere volgorde</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Antwoorden</translation>
    </message>
    <message>
        <source>Where the answers stand, each test&apos;s on a page of its own</source>
        <translation>Waar de antwoorden staan, die van elke toets op een eigen pagina</translation>
    </message>
    <message>
        <source>Beside names and labels</source>
        <translation>Naast namen en labels</translation>
    </message>
    <message>
        <source>Nothing else, no names</source>
        <translation>Alleen, zonder namen</translation>
    </message>
    <message>
        <source>&amp;Quiz</source>
        <translation>&amp;Quiz</translation>
    </message>
    <message>
        <source>What the page asks; alone, no name of a structure is in its file</source>
        <translation>Wat de pagina vraagt; alleen staat er geen naam van een structuur in het bestand</translation>
    </message>
    <message>
        <source>Where is it?</source>
        <translation>Waar is het?</translation>
    </message>
    <message>
        <source>The quiz names something, and it is clicked</source>
        <translation>De quiz noemt iets, dat wordt aangeklikt</translation>
    </message>
    <message>
        <source>What is it? Typed</source>
        <translation>Wat is het? Getypt</translation>
    </message>
    <message>
        <source>The quiz lights something up, and its name is typed</source>
        <translation>De quiz licht iets op, waarvan de naam wordt getypt</translation>
    </message>
    <message>
        <source>What is it? One of four</source>
        <translation>Wat is het? Eén van vier</translation>
    </message>
    <message>
        <source>The other three names are of neighbours and of the same kind</source>
        <translation>De andere drie namen zijn van buren en van dezelfde soort</translation>
    </message>
    <message>
        <source>Order along a path</source>
        <translation>Volgorde langs een weg</translation>
    </message>
    <message>
        <source>Where a group is a chain of vessels, the quiz asks for their order</source>
        <translation>Waar een groep een keten van vaten is, vraagt de quiz naar hun volgorde</translation>
    </message>
    <message>
        <source>Labels to their places</source>
        <translation>Labels naar hun plaats</translation>
    </message>
    <message>
        <source>Labels are dragged to what they name</source>
        <translation>Labels worden gesleept naar wat ze benoemen</translation>
    </message>
    <message>
        <source>Answers count</source>
        <translation>Antwoorden tellen</translation>
    </message>
    <message>
        <source>The page tells how many were right</source>
        <translation>De pagina zegt hoeveel er goed waren</translation>
    </message>
    <message>
        <source>No turning meanwhile</source>
        <translation>Intussen niet draaien</translation>
    </message>
    <message>
        <source>While something is asked, the anatomy cannot be turned</source>
        <translation>Terwijl er iets wordt gevraagd, kan de anatomie niet worden gedraaid</translation>
    </message>
    <message>
        <source>No hiding meanwhile</source>
        <translation>Intussen niet verbergen</translation>
    </message>
    <message>
        <source>While something is asked, nothing can be hidden and no Γ changed</source>
        <translation>Terwijl er iets wordt gevraagd, kan er niets worden verborgen en geen Γ worden veranderd</translation>
    </message>
    <message>
        <source>Title of the page</source>
        <translation>Titel van de pagina</translation>
    </message>
    <message>
        <source>Languages</source>
        <translation>Talen</translation>
    </message>
    <message>
        <source>As in “de, la”; empty: all in which there are names</source>
        <translation>Zoals in “de, la”; leeg: alle waarin er namen zijn</translation>
    </message>
    <message>
        <source>Triangles at most</source>
        <translation>Driehoeken hooguit</translation>
    </message>
    <message>
        <source>Fewer make a smaller file and a quicker page; 0: all there are</source>
        <translation>Minder geeft een kleiner bestand en een snellere pagina; 0: alle die er zijn</translation>
    </message>
    <message>
        <source>Surfaces off by</source>
        <translation>Oppervlakken wijken af</translation>
    </message>
    <message>
        <source>Surfaces that may be a little off need fewer triangles; 0: exact</source>
        <translation>Oppervlakken die iets mogen afwijken, hebben minder driehoeken nodig; 0: exact</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Geslaagd vanaf</translation>
    </message>
    <message>
        <source>The share of right answers that the learning system takes as passed</source>
        <translation>Het deel goede antwoorden dat de leeromgeving als geslaagd telt</translation>
    </message>
    <message>
        <source>Else what the group that holds all is called, or where there is none the file</source>
        <translation>Anders hoe de groep heet die alles bevat, of het bestand als er geen is</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolutie</translation>
    </message>
    <message>
        <source>Pixels to the inch of PNG and TIFF; journals ask for 300 or 600, and for up to 1200 where there are lines alone</source>
        <translation>Pixels per inch van PNG en TIFF; tijdschriften vragen 300 of 600, en tot 1200 waar er alleen lijnen zijn</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>1 bit, ink or paper</source>
        <translation>1 bit, inkt of papier</translation>
    </message>
    <message>
        <source>1 bit is for black and white figures, as printers take line art</source>
        <translation>1 bit is voor figuren in zwart-wit, zoals drukkers lijntekeningen nemen</translation>
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
        <translation>&amp;Demo</translation>
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
        <translation>A&amp;chtergrond</translation>
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
        <source>Read meshes again whose files have changed</source>
        <translation>Meshes opnieuw lezen waarvan het bestand is gewijzigd</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>A&amp;fsluiten</translation>
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
        <source>Double click</source>
        <translation>Dubbelklik</translation>
    </message>
    <message>
        <source>Turn around this place from now on</source>
        <translation>Voortaan om deze plek draaien</translation>
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
    <message>
        <source>hides up to %1 % of it</source>
        <translation>bedekt tot %1 % ervan</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gekozen</translation>
    </message>
    <message>
        <source>Thin and long, comes to it</source>
        <translation>Dun en lang, komt erbij</translation>
    </message>
    <message>
        <source>Where %1 comes from</source>
        <translation>Waar %1 vandaan komt</translation>
    </message>
    <message>
        <source>Lies against it</source>
        <translation>Ligt ertegenaan</translation>
    </message>
    <message>
        <source>Lies outside, %1</source>
        <translation>Ligt erbuiten, %1</translation>
    </message>
    <message>
        <source>In focus</source>
        <translation>In focus</translation>
    </message>
    <message>
        <source>Neighbour</source>
        <translation>Buur</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Buren</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Omhulsel</translation>
    </message>
    <message>
        <source>Shells around it</source>
        <translation>Omhulsels eromheen</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Achtergrond</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Its rights do not let it be written to</source>
        <translation>De rechten staan schrijven niet toe</translation>
    </message>
    <message>
        <source>Another program has changed it since</source>
        <translation>Een ander programma heeft het sindsdien gewijzigd</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>‘%1’ bestaat al. Vervangen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
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
        <source>Sline scenes (*.sline)</source>
        <translation>Sline-scènes (*.sline)</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Wijzigingen in ‘%1’ opslaan?</translation>
    </message>
    <message>
        <source>Changes that are not saved will be lost.</source>
        <translation>Niet-opgeslagen wijzigingen gaan verloren.</translation>
    </message>
    <message>
        <source>Go back to “%1” as it was saved last?</source>
        <translation>Terug naar ‘%1’ zoals het laatst is opgeslagen?</translation>
    </message>
    <message>
        <source>Undo brings back what was changed since.</source>
        <translation>Ongedaan maken brengt terug wat sindsdien is gewijzigd.</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Terugzetten</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Onlangs g&amp;eopend</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nieuw</translation>
    </message>
    <message>
        <source>A scene without anything in it</source>
        <translation>Een scène zonder iets erin</translation>
    </message>
    <message>
        <source>Open scenes, meshes, label volumes and other files</source>
        <translation>Scènes, meshes, labelvolumes en andere bestanden openen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Op&amp;slaan</translation>
    </message>
    <message>
        <source>Write the scene file</source>
        <translation>Het scènebestand schrijven</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Opslaan &amp;als…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Write another scene file and go on with that</source>
        <translation>Een ander scènebestand schrijven en daarmee verdergaan</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>&amp;Kopie opslaan…</translation>
    </message>
    <message>
        <source>Write another scene file and go on with this one</source>
        <translation>Een ander scènebestand schrijven en met dit verdergaan</translation>
    </message>
    <message>
        <source>Re&amp;vert to Saved…</source>
        <translation>&amp;Terug naar opgeslagen…</translation>
    </message>
    <message>
        <source>Read the scene file again; what was changed since is undone</source>
        <translation>Het scènebestand opnieuw lezen; wat sindsdien is gewijzigd, vervalt</translation>
    </message>
    <message>
        <source>Recover &amp;Unsaved Work…</source>
        <translation>Niet-opgeslagen &amp;werk herstellen…</translation>
    </message>
    <message>
        <source>What was kept when the program did not end as it should</source>
        <translation>Wat bewaard is toen het programma niet goed eindigde</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Sl&amp;uiten</translation>
    </message>
    <message>
        <source>Close the scene and go to the start page</source>
        <translation>De scène sluiten en naar de startpagina gaan</translation>
    </message>
    <message>
        <source>The selected structures in detail, everything else by what it is to them</source>
        <translation>De gekozen structuren in detail, al het andere naar wat het voor ze is</translation>
    </message>
    <message>
        <source>&amp;Help on This</source>
        <translation>&amp;Hulp hierbij</translation>
    </message>
    <message>
        <source>The page about the panel that has the keyboard</source>
        <translation>De pagina over het paneel dat het toetsenbord heeft</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Weggesneden</translation>
    </message>
    <message>
        <source>Orientation cube</source>
        <translation>Oriëntatiekubus</translation>
    </message>
    <message>
        <source>The body&apos;s sides in the corner of the picture; a click looks from there</source>
        <translation>De kanten van het lichaam in de hoek van het beeld; een klik kijkt van daar</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Schaalbalk</translation>
    </message>
    <message>
        <source>True at the depth of what the picture turns around</source>
        <translation>Klopt op de diepte van dat waar het beeld om draait</translation>
    </message>
    <message>
        <source>Names under the mouse</source>
        <translation>Namen onder de muis</translation>
    </message>
    <message>
        <source>What a structure is called where the mouse rests</source>
        <translation>Hoe een structuur heet waar de muis rust</translation>
    </message>
    <message>
        <source>Time that a picture takes</source>
        <translation>Tijd die een beeld kost</translation>
    </message>
    <message>
        <source>In milliseconds, in the corner of the picture</source>
        <translation>In milliseconden, in de hoek van het beeld</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Muis</translation>
    </message>
    <message>
        <source>Mouse buttons as in</source>
        <translation>Muisknoppen zoals in</translation>
    </message>
    <message>
        <source>Which buttons and keys turn, move and zoom the picture; H shows them</source>
        <translation>Welke knoppen en toetsen het beeld draaien, verschuiven en zoomen; H toont ze</translation>
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
        <translation>Korte vluchten tussen aanzichten</translation>
    </message>
    <message>
        <source>Off: the picture changes at once</source>
        <translation>Uit: het beeld verandert meteen</translation>
    </message>
    <message>
        <source>Sagittal section</source>
        <translation>Sagittale doorsnede</translation>
    </message>
    <message>
        <source>Coronal section</source>
        <translation>Coronale doorsnede</translation>
    </message>
    <message>
        <source>Axial section</source>
        <translation>Axiale doorsnede</translation>
    </message>
    <message>
        <source>Oblique section</source>
        <translation>Schuine doorsnede</translation>
    </message>
    <message>
        <source>Whole scene</source>
        <translation>Hele scène</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Ontgrendelen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isoleren</translation>
    </message>
    <message>
        <source>Hide Others</source>
        <translation>Andere verbergen</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles tonen</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Schim</translation>
    </message>
    <message>
        <source>Inherit Γ</source>
        <translation>Γ overnemen</translation>
    </message>
    <message>
        <source>Inherit Colour</source>
        <translation>Kleur overnemen</translation>
    </message>
    <message>
        <source>Inherit Opacity</source>
        <translation>Dekking overnemen</translation>
    </message>
    <message>
        <source>Inherit All</source>
        <translation>Alles overnemen</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Groep opheffen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verplaatsen</translation>
    </message>
    <message>
        <source>%1, its own</source>
        <translation>%1, eigen</translation>
    </message>
    <message>
        <source>%1, inherited</source>
        <translation>%1, overgenomen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>open</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>dekkend</translation>
    </message>
    <message>
        <source>tint</source>
        <translation>tint</translation>
    </message>
    <message>
        <source>veil</source>
        <translation>sluier</translation>
    </message>
    <message>
        <source>simplified from %1 triangles, at most %2 mm off</source>
        <translation>vereenvoudigd uit %1 driehoeken, hoogstens %2 mm ernaast</translation>
    </message>
    <message>
        <source>smoothed in %1 steps, at most %2 mm off</source>
        <translation>gladgemaakt in %1 stappen, hoogstens %2 mm ernaast</translation>
    </message>
    <message>
        <source>refined in %1 steps</source>
        <translation>verfijnd in %1 stappen</translation>
    </message>
    <message>
        <source>%1 faces mended</source>
        <translation>%1 vlakken hersteld</translation>
    </message>
    <message>
        <source>moved as its scene says</source>
        <translation>verplaatst zoals de scène zegt</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>zoals in het bestand</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>made by the program</source>
        <translation>door het programma gemaakt</translation>
    </message>
    <message>
        <source>Part of the file</source>
        <translation>Deel van het bestand</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coördinaten</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Eenheid</translation>
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
        <translation>Kleur</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Dekking</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Between the lines</source>
        <translation>Tussen de lijnen</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Lijndikte</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Getoond</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nee</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vergrendeld</translation>
    </message>
    <message>
        <source>by the group above</source>
        <translation>door de groep erboven</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Driehoeken</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>none: the surface has holes</source>
        <translation>geen: het oppervlak heeft gaten</translation>
    </message>
    <message>
        <source>%1, of %2 closed surfaces</source>
        <translation>%1, van %2 gesloten oppervlakken</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Slepen met de middelste knop</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Slepen met rechts</translation>
    </message>
    <message>
        <source>Zoom: upwards is nearer</source>
        <translation>Zoomen: omhoog is dichterbij</translation>
    </message>
    <message>
        <source>Roll the picture around its middle</source>
        <translation>Het beeld om zijn midden rollen</translation>
    </message>
    <message>
        <source>Two fingers on a touchpad</source>
        <translation>Twee vingers op een touchpad</translation>
    </message>
    <message>
        <source>Move the picture; pinch to zoom</source>
        <translation>Het beeld verschuiven; knijpen om te zoomen</translation>
    </message>
    <message>
        <source>Select what is seen there</source>
        <translation>Kies wat daar te zien is</translation>
    </message>
    <message>
        <source>Add to the selection, or take away from it</source>
        <translation>Aan de selectie toevoegen of eruit halen</translation>
    </message>
    <message>
        <source>Select the next structure behind; after the last the first</source>
        <translation>Kies de volgende structuur erachter; na de laatste de eerste</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklik</translation>
    </message>
    <message>
        <source>Drag the arrow of a section</source>
        <translation>De pijl van een doorsnede slepen</translation>
    </message>
    <message>
        <source>Move the plane; with Ctrl in whole steps</source>
        <translation>Het vlak verschuiven; met Ctrl in hele stappen</translation>
    </message>
    <message>
        <source>Click on the arrow&apos;s head</source>
        <translation>Klik op de pijlpunt</translation>
    </message>
    <message>
        <source>Keep the other side of the section</source>
        <translation>De andere kant van de doorsnede houden</translation>
    </message>
    <message>
        <source>Drag a ring of a section</source>
        <translation>Een ring van een doorsnede slepen</translation>
    </message>
    <message>
        <source>Tilt the plane; with Ctrl in steps of 15°</source>
        <translation>Het vlak kantelen; met Ctrl in stappen van 15°</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pijltoetsen</translation>
    </message>
    <message>
        <source>Turn by %1°</source>
        <translation>%1° draaien</translation>
    </message>
    <message>
        <source>Plus, minus</source>
        <translation>Plus, min</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>&amp;Inherit</source>
        <translation>&amp;Overnemen</translation>
    </message>
    <message>
        <source>&amp;Over the Picture</source>
        <translation>Over het b&amp;eeld</translation>
    </message>
    <message>
        <source>Re&amp;load from Source</source>
        <translation>Opnieuw &amp;laden van de bron</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>Sch&amp;im</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>The selected structures as outlines under a veil</source>
        <translation>De gekozen structuren als omtrekken onder een sluier</translation>
    </message>
    <message>
        <source>Co&amp;lour…</source>
        <translation>Kle&amp;ur…</translation>
    </message>
    <message>
        <source>Another colour for the selected</source>
        <translation>Een andere kleur voor de gekozen</translation>
    </message>
    <message>
        <source>Inherit &amp;Γ</source>
        <translation>&amp;Γ overnemen</translation>
    </message>
    <message>
        <source>Inherit &amp;Colour</source>
        <translation>&amp;Kleur overnemen</translation>
    </message>
    <message>
        <source>Take the colour from the group above again</source>
        <translation>De kleur weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Inherit &amp;Opacity</source>
        <translation>&amp;Dekking overnemen</translation>
    </message>
    <message>
        <source>Take the opacity from the group above again</source>
        <translation>De dekking weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Inherit &amp;All</source>
        <translation>&amp;Alles overnemen</translation>
    </message>
    <message>
        <source>Take the whole look from the group above again</source>
        <translation>Het hele uiterlijk weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Show the selected structures and nothing else; again: everything</source>
        <translation>Alleen de gekozen structuren tonen; nogmaals: alles</translation>
    </message>
    <message>
        <source>Hide &amp;Others</source>
        <translation>An&amp;dere verbergen</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Hide all but the selected structures</source>
        <translation>Alles behalve de gekozen structuren verbergen</translation>
    </message>
    <message>
        <source>&amp;Zoom To</source>
        <translation>Inzoo&amp;men</translation>
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
        <translation>De gekozen structuren in beeld brengen en eromheen draaien</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Hernoemen</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Another name</source>
        <translation>Een andere naam</translation>
    </message>
    <message>
        <source>Ne&amp;w Group</source>
        <translation>Nieuwe &amp;groep</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>An empty group</source>
        <translation>Een lege groep</translation>
    </message>
    <message>
        <source>Grou&amp;p</source>
        <translation>Groe&amp;peren</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>The selected structures in a group of their own</source>
        <translation>De gekozen structuren in een eigen groep</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Groep opheffe&amp;n</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Dissolve the selected groups; what is in them keeps its look</source>
        <translation>De gekozen groepen opheffen; wat erin zit houdt zijn uiterlijk</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>Vergrende&amp;len</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>What is locked keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Wat vergrendeld is, houdt uiterlijk, naam en plaats en kan in het beeld niet aangeklikt worden</translation>
    </message>
    <message>
        <source>Alt+Return</source>
        <translation>Alt+Return</translation>
    </message>
    <message>
        <source>Where it came from, how large it is, how it is drawn</source>
        <translation>Waar het vandaan komt, hoe groot het is, hoe het getekend wordt</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Cut across the line of sight</source>
        <translation>Dwars op de kijkrichting snijden</translation>
    </message>
    <message>
        <source>&amp;Orientation Cube</source>
        <translation>&amp;Oriëntatiekubus</translation>
    </message>
    <message>
        <source>Scale &amp;Bar</source>
        <translation>&amp;Schaalbalk</translation>
    </message>
    <message>
        <source>How long a centimetre is</source>
        <translation>Hoe lang een centimeter is</translation>
    </message>
    <message>
        <source>&amp;Names under the Mouse</source>
        <translation>&amp;Namen onder de muis</translation>
    </message>
    <message>
        <source>Picture &amp;Time</source>
        <translation>Beeld&amp;tijd</translation>
    </message>
    <message>
        <source>How long the last picture took to draw</source>
        <translation>Hoe lang het tekenen van het laatste beeld duurde</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Spatie</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Bring the selected structures into the picture</source>
        <translation>De gekozen structuren in beeld brengen</translation>
    </message>
    <message>
        <source>Drag over eyes or locks</source>
        <translation>Over ogen of sloten slepen</translation>
    </message>
    <message>
        <source>Set them all alike</source>
        <translation>Alle gelijk zetten</translation>
    </message>
    <message>
        <source>Alt + click on an eye</source>
        <translation>Alt + klik op een oog</translation>
    </message>
    <message>
        <source>Show this and nothing else; again: everything</source>
        <translation>Alleen dit tonen; nogmaals: alles</translation>
    </message>
    <message>
        <source>Middle click on Γ or colour</source>
        <translation>Middelklik op Γ of kleur</translation>
    </message>
    <message>
        <source>Take it from the group above again</source>
        <translation>Het weer van de groep erboven nemen</translation>
    </message>
    <message>
        <source>Drag rows</source>
        <translation>Rijen slepen</translation>
    </message>
    <message>
        <source>Put them elsewhere, or into another group</source>
        <translation>Ergens anders of in een andere groep zetten</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Dubbelklik op een naam</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>New Group</source>
        <translation>Nieuwe groep</translation>
    </message>
    <message>
        <source>How wide lines are, times the usual; 0 draws none</source>
        <translation>Hoe breed lijnen zijn, maal het gewone; 0 tekent er geen</translation>
    </message>
    <message>
        <source>Hatching: strokes</source>
        <translation>Arcering: streken</translation>
    </message>
    <message>
        <source>How many strokes hatching has, times the usual; its tone stays</source>
        <translation>Hoeveel streken de arcering heeft, maal het gewone; de toon blijft</translation>
    </message>
    <message>
        <source>Hatching: tone</source>
        <translation>Arcering: toon</translation>
    </message>
    <message>
        <source>How dark hatching is, times the usual, by the width of its strokes</source>
        <translation>Hoe donker de arcering is, maal het gewone, door de breedte van de streken</translation>
    </message>
    <message>
        <source>How much of what lies behind the colour is hidden; lines stay</source>
        <translation>Hoeveel van wat achter de kleur ligt bedekt is; lijnen blijven</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Of the shaded surface and of washes</source>
        <translation>Van het oppervlak met schaduw en van tinten</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Inkt</translation>
    </message>
    <message>
        <source>Of lines and hatching; else black, or light on a dark background</source>
        <translation>Van lijnen en arcering; anders zwart, of licht op een donkere achtergrond</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Always show import options</source>
        <translation>Importopties altijd tonen</translation>
    </message>
    <message>
        <source>Before meshes are opened: units, smoothing and what is left out</source>
        <translation>Voordat meshes geopend worden: eenheden, gladmaken en wat weggelaten wordt</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importeren…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>See and change what an import would do, before it is done</source>
        <translation>Zien en wijzigen wat een import zou doen, voordat het gebeurt</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>The same for all meshes in a folder</source>
        <translation>Hetzelfde voor alle meshes in een map</translation>
    </message>
    <message>
        <source>Import Op&amp;tions…</source>
        <translation>Importopties wi&amp;jzigen…</translation>
    </message>
    <message>
        <source>Import what is open once more, with other units, smoothing or choice</source>
        <translation>Wat open is nogmaals importeren, met andere eenheden, gladmaking of keuze</translation>
    </message>
    <message>
        <source>Proper&amp;ties…</source>
        <translation>&amp;Eigenschappen…</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>&amp;Dwars op de blik</translation>
    </message>
    <message>
        <source>I&amp;mport Folder…</source>
        <translation>Ma&amp;p importeren…</translation>
    </message>
    <message>
        <source>A&amp;dd View</source>
        <translation>Aan&amp;zicht toevoegen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Save what you see as a view: camera, what is shown, Γ, colours and sections</source>
        <translation>Bewaar wat u ziet als aanzicht: camera, wat wordt getoond, Γ, kleuren en doorsneden</translation>
    </message>
    <message>
        <source>Presen&amp;t</source>
        <translation>Presen&amp;teren</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>The saved views one after the other on the whole screen</source>
        <translation>De opgeslagen aanzichten na elkaar op het hele scherm</translation>
    </message>
    <message>
        <source>The scene&apos;s own</source>
        <translation>Die van de scène</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Teksten</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Nummers</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Labels</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message numerus="yes">
        <source>%n structures, seen as in the window.</source>
        <translation>
            <numerusform>%n structuur, gezien als in het venster.</numerusform>
            <numerusform>%n structuren, gezien als in het venster.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n structures as surfaces.</source>
        <translation>
            <numerusform>%n structuur als oppervlak.</numerusform>
            <numerusform>%n structuren als oppervlakken.</numerusform>
        </translation>
    </message>
    <message>
        <source>No labels.</source>
        <translation>Geen labels.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels as numbers.</source>
        <translation>
            <numerusform>%n label als nummer.</numerusform>
            <numerusform>%n labels als nummers.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels as blank lines.</source>
        <translation>
            <numerusform>%n label als lege regel.</numerusform>
            <numerusform>%n labels als lege regels.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels in the scene&apos;s own language.</source>
        <translation>
            <numerusform>%n label in de taal van de scène.</numerusform>
            <numerusform>%n labels in de taal van de scène.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels, language: %1.</source>
        <translation>
            <numerusform>%n label, taal: %1.</numerusform>
            <numerusform>%n labels, taal: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, as lines and shapes of any sharpness.</source>
        <translation>%1, als lijnen en vlakken, scherp op elke grootte.</translation>
    </message>
    <message>
        <source>%1, %2 at %3 dpi.</source>
        <translation>%1, %2 bij %3 dpi.</translation>
    </message>
    <message>
        <source>Names of structures, groups and views are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Namen van structuren, groepen en aanzichten staan in het bestand zoals de scène ze heeft. Geen paden, gebruikersnamen, datums of patiëntgegevens.</translation>
    </message>
    <message>
        <source>Nothing is in the file but what is seen: no paths, user names, dates or patient data.</source>
        <translation>In het bestand staat alleen wat te zien is: geen paden, gebruikersnamen, datums of patiëntgegevens.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>No structure is shown: the picture would be empty.</source>
        <translation>Er wordt geen structuur getoond: de afbeelding zou leeg zijn.</translation>
    </message>
    <message>
        <source>The view “%1” shows no structure: its picture would be empty.</source>
        <translation>Het aanzicht “%1” toont geen structuur: de afbeelding zou leeg zijn.</translation>
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
        <translation>Dia 16:9</translation>
    </message>
    <message>
        <source>Journal column</source>
        <translation>Tijdschriftkolom</translation>
    </message>
    <message>
        <source>A1 poster</source>
        <translation>Poster A1</translation>
    </message>
    <message>
        <source>Say what the file is to be called.</source>
        <translation>Zeg hoe het bestand moet heten.</translation>
    </message>
    <message>
        <source>The name is too long for a file: take a shorter one.</source>
        <translation>De naam is te lang voor een bestand: neem een kortere.</translation>
    </message>
    <message>
        <source>There is no folder “%1”: choose one that is there.</source>
        <translation>Er is geen map “%1”: kies een die er is.</translation>
    </message>
    <message>
        <source>“%1” is a file and no folder: choose a folder.</source>
        <translation>“%1” is een bestand en geen map: kies een map.</translation>
    </message>
    <message>
        <source>“%1” is a folder: give the file another name.</source>
        <translation>“%1” is een map: geef het bestand een andere naam.</translation>
    </message>
    <message>
        <source>You may not write to “%1”: choose another folder or name.</source>
        <translation>Je mag niet naar “%1” schrijven: kies een andere map of naam.</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xporteren…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write pictures, drawings and other files for print, teaching and other programs</source>
        <translation>Afbeeldingen, tekeningen en andere bestanden schrijven voor druk, onderwijs en andere programma’s</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Afbeelding &amp;kopiëren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>The picture on the clipboard, with its labels, for other programs</source>
        <translation>De afbeelding op het klembord, met haar labels, voor andere programma’s</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>een plaats</translation>
    </message>
    <message>
        <source>nothing that is there</source>
        <translation>niets dat er is</translation>
    </message>
    <message>
        <source>Callout</source>
        <translation>Bijschrift</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Speld</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Afstand</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The scene’s own</source>
        <translation>Die van de scène</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Labels show</source>
        <translation>Labels tonen</translation>
    </message>
    <message>
        <source>Numbers are for a key beside the picture, blank lines for a test</source>
        <translation>Nummers zijn voor een legenda naast het beeld, lege regels voor een toets</translation>
    </message>
    <message>
        <source>Blank lines</source>
        <translation>Lege regels</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Niets</translation>
    </message>
    <message>
        <source>What labels say, where they have words in that language; else the scene’s own</source>
        <translation>Wat labels zeggen, waar ze woorden in die taal hebben; anders die van de scène</translation>
    </message>
    <message>
        <source>As the structures</source>
        <translation>Zoals de structuren</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Grootte van de letters</translation>
    </message>
    <message>
        <source>As on paper, whatever the size of the picture</source>
        <translation>Zoals op papier, hoe groot het beeld ook is</translation>
    </message>
    <message>
        <source>S&amp;how as</source>
        <translation>&amp;Tonen als</translation>
    </message>
    <message>
        <source>&amp;Label</source>
        <translation>&amp;Label</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Click on a structure and type what it is called</source>
        <translation>Klik op een structuur en typ hoe ze heet</translation>
    </message>
    <message>
        <source>&amp;Callout</source>
        <translation>Bijs&amp;chrift</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Click on a place and type a few lines, which stand in a frame</source>
        <translation>Klik op een plaats en typ enkele regels, die in een kader staan</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>&amp;Speld</translation>
    </message>
    <message>
        <source>Shift+P</source>
        <translation>Shift+P</translation>
    </message>
    <message>
        <source>Click on a place to mark it; its text stands beside it</source>
        <translation>Klik op een plaats om die te markeren; de tekst staat ernaast</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Afstand</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Click on two places to measure between them</source>
        <translation>Klik op twee plaatsen om ertussen te meten</translation>
    </message>
    <message>
        <source>Label the &amp;Selected</source>
        <translation>Het &amp;geselecteerde benoemen</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>The selected structures get labels with their names, where they are best seen</source>
        <translation>De geselecteerde structuren krijgen labels met hun namen, waar ze het best te zien zijn</translation>
    </message>
    <message>
        <source>&amp;Edit Text</source>
        <translation>Tekst &amp;bewerken</translation>
    </message>
    <message>
        <source>Type what the chosen label says (F2 in the picture)</source>
        <translation>Typ wat het gekozen label zegt (F2 in het beeld)</translation>
    </message>
    <message>
        <source>Dele&amp;te Label</source>
        <translation>Label &amp;verwijderen</translation>
    </message>
    <message>
        <source>Take the chosen label away (Del in the picture)</source>
        <translation>Het gekozen label weghalen (Del in het beeld)</translation>
    </message>
    <message>
        <source>Author and rights are in the file as you typed them.</source>
        <translation>Maker en rechten staan in het bestand zoals u ze hebt getypt.</translation>
    </message>
    <message>
        <source>the view&apos;s name</source>
        <translation>de naam van het aanzicht</translation>
    </message>
    <message>
        <source>the scale bar</source>
        <translation>de schaalbalk</translation>
    </message>
    <message>
        <source>the legend</source>
        <translation>de legenda</translation>
    </message>
    <message>
        <source>what sections have taken away</source>
        <translation>wat doorsneden hebben weggenomen</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 en nog %n</numerusform>
            <numerusform>%1 en nog %n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room: %1.</source>
        <translation>
            <numerusform>%n label vond geen plaats: %1.</numerusform>
            <numerusform>%n labels vonden geen plaats: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are left out, as nothing is drawn there: %1.</source>
        <translation>
            <numerusform>%n label is weggelaten, want daar is niets getekend: %1.</numerusform>
            <numerusform>%n labels zijn weggelaten, want daar is niets getekend: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels point to places beside the picture: %1.</source>
        <translation>
            <numerusform>%n label wijst naar een plaats buiten het beeld: %1.</numerusform>
            <numerusform>%n labels wijzen naar plaatsen buiten het beeld: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels have no text in the language and stand in the scene&apos;s own: %1.</source>
        <translation>
            <numerusform>%n label heeft geen tekst in de taal en staat in die van de scène: %1.</numerusform>
            <numerusform>%n labels hebben geen tekst in de taal en staan in die van de scène: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels found no room and have no card: %1.</source>
        <translation>
            <numerusform>%n label vond geen plaats en heeft geen kaart: %1.</numerusform>
            <numerusform>%n labels vonden geen plaats en hebben geen kaart: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the picture&apos;s edge there is no room for: %1.</source>
        <translation>Aan de rand van het beeld is geen plaats voor: %1.</translation>
    </message>
    <message>
        <source>R and L are left out: nobody knows the directions of what is drawn.</source>
        <translation>R en L zijn weggelaten: niemand kent de richtingen van wat getekend is.</translation>
    </message>
    <message numerus="yes">
        <source>%n texts are shortened: %1.</source>
        <translation>
            <numerusform>%n tekst is ingekort: %1.</numerusform>
            <numerusform>%n teksten zijn ingekort: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections cut nothing in the file, which holds whole surfaces: %1.</source>
        <translation>
            <numerusform>%n doorsnede snijdt niets in het bestand, want dat bevat hele oppervlakken: %1.</numerusform>
            <numerusform>%n doorsneden snijden niets in het bestand, want dat bevat hele oppervlakken: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is transparent stands on white.</source>
        <translation>Wat doorzichtig is, staat op wit.</translation>
    </message>
    <message>
        <source>This kind has fewer bits than were chosen.</source>
        <translation>Deze soort heeft minder bits dan er gekozen zijn.</translation>
    </message>
    <message>
        <source>The film is %1 pixels large, as its sides are even numbers.</source>
        <translation>De film is %1 pixels groot, want zijn zijden zijn even getallen.</translation>
    </message>
    <message>
        <source>The film takes %1 seconds, as it has whole pictures alone.</source>
        <translation>De film duurt %1 seconden, want hij heeft alleen hele beelden.</translation>
    </message>
    <message>
        <source>Take a larger page, smaller letters, or numbers.</source>
        <translation>Neem een grotere pagina, kleinere letters of nummers.</translation>
    </message>
    <message>
        <source>Show the structures, or hide the labels, too.</source>
        <translation>Toon de structuren, of verberg ook de labels.</translation>
    </message>
    <message>
        <source>Choose a view that shows them.</source>
        <translation>Kies een aanzicht dat ze toont.</translation>
    </message>
    <message>
        <source>Write them in the list of labels, or choose another language.</source>
        <translation>Schrijf ze in de lijst met labels, of kies een andere taal.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters.</source>
        <translation>Neem een grotere pagina of kleinere letters.</translation>
    </message>
    <message>
        <source>Say them when the files are imported.</source>
        <translation>Geef ze op bij het importeren van de bestanden.</translation>
    </message>
    <message>
        <source>Write less, or take larger paper.</source>
        <translation>Schrijf minder, of neem groter papier.</translation>
    </message>
    <message>
        <source>Export a picture or a drawing to show the cut.</source>
        <translation>Exporteer een beeld of een tekening om de snede te tonen.</translation>
    </message>
    <message>
        <source>Take PNG, TIFF, SVG or WebP to keep it transparent.</source>
        <translation>Neem PNG, TIFF, SVG of WebP om het doorzichtig te houden.</translation>
    </message>
    <message>
        <source>Take PNG or TIFF for more.</source>
        <translation>Neem PNG of TIFF voor meer.</translation>
    </message>
    <message>
        <source>The text is for a patient&apos;s sheet: this one does not have it.</source>
        <translation>De tekst hoort op een blad voor patiënten: dit blad heeft hem niet.</translation>
    </message>
    <message>
        <source>&amp;Print Proof…</source>
        <translation>D&amp;rukproef…</translation>
    </message>
    <message>
        <source>Find neighbours that a press without colours or some eyes cannot tell apart, and what would help</source>
        <translation>Vindt buren die een druk zonder kleuren of sommige ogen niet onderscheiden, en wat zou helpen</translation>
    </message>
    <message>
        <source>Files from outside open in</source>
        <translation>Bestanden van buiten openen in</translation>
    </message>
    <message>
        <source>What a file manager or a command names while a window is open</source>
        <translation>Wat een bestandsbeheerder of een opdracht noemt terwijl een venster open is</translation>
    </message>
    <message>
        <source>The open window</source>
        <translation>Het open venster</translation>
    </message>
    <message>
        <source>A window of their own</source>
        <translation>Een eigen venster</translation>
    </message>
    <message>
        <source>Look of what is opened</source>
        <translation>Uiterlijk bij openen</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Eenvoudig</translation>
    </message>
    <message>
        <source>Dra&amp;w as Plate</source>
        <translation>Als plaat te&amp;kenen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>What the scene is about in detail, seen from where it shows best, everything else as context</source>
        <translation>Waar de scène over gaat in detail, gezien vanwaar het zich het best toont; al het andere als omgeving</translation>
    </message>
    <message>
        <source>Another S&amp;ubject</source>
        <translation>Ander onder&amp;werp</translation>
    </message>
    <message>
        <source>A plate of what else the scene may be about; again for the next</source>
        <translation>Een plaat van iets anders waar de scène over kan gaan; nogmaals voor het volgende</translation>
    </message>
    <message>
        <source>lesion</source>
        <translation>laesie</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>orgaan</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>vat</translation>
    </message>
    <message>
        <source>nerve</source>
        <translation>zenuw</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>bot</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>gewricht</translation>
    </message>
    <message>
        <source>muscle</source>
        <translation>spier</translation>
    </message>
    <message>
        <source>skin</source>
        <translation>huid</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>structuur</translation>
    </message>
    <message>
        <source>the subject</source>
        <translation>het onderwerp</translation>
    </message>
    <message>
        <source>it comes to the subject</source>
        <translation>ze komt bij het onderwerp</translation>
    </message>
    <message>
        <source>it is near the subject</source>
        <translation>ze ligt dicht bij het onderwerp</translation>
    </message>
    <message>
        <source>it lies outside and hides the subject</source>
        <translation>ze ligt erbuiten en verbergt het onderwerp</translation>
    </message>
    <message>
        <source>it is away from the subject</source>
        <translation>ze ligt ver van het onderwerp</translation>
    </message>
    <message>
        <source>not drawn: more context would show it</source>
        <translation>niet getekend: meer context zou het tonen</translation>
    </message>
    <message>
        <source>in detail: it is the subject</source>
        <translation>in detail: het is het onderwerp</translation>
    </message>
    <message>
        <source>solid and pale: the subject lies in it</source>
        <translation>dekkend en bleek: het onderwerp ligt erin</translation>
    </message>
    <message>
        <source>outline: %1 in front of the subject</source>
        <translation>omtrek: %1 voor het onderwerp</translation>
    </message>
    <message>
        <source>modelled: %1 that comes to the subject</source>
        <translation>gemodelleerd: %1 dat bij het onderwerp komt</translation>
    </message>
    <message>
        <source>solid: %1 near the subject</source>
        <translation>dekkend: %1 bij het onderwerp</translation>
    </message>
    <message>
        <source>solid and pale: %1 away from the subject</source>
        <translation>dekkend en bleek: %1 ver van het onderwerp</translation>
    </message>
    <message>
        <source>lines: %1</source>
        <translation>lijnen: %1</translation>
    </message>
    <message>
        <source>Ligands</source>
        <translation>Liganden</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Laesies</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organen</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gewrichten</translation>
    </message>
    <message>
        <source>Vessels and nerves</source>
        <translation>Vaten en zenuwen</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Botten</translation>
    </message>
    <message>
        <source>What lies in the organs</source>
        <translation>Wat in de organen ligt</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Line weight</source>
        <translation>Lijndruk</translation>
    </message>
    <message>
        <source>How much the pen&apos;s width tells light, depth and form; 0 is an even pen</source>
        <translation>Hoeveel de breedte van de pen licht, diepte en vorm laat zien; 0 is een gelijkmatige pen</translation>
    </message>
    <message>
        <source>Line smoothing</source>
        <translation>Lijnen gladmaken</translation>
    </message>
    <message>
        <source>How far lines leave what turns back and forth, times the usual</source>
        <translation>Hoe ver lijnen loslaten wat heen en weer gaat, keer het gebruikelijke</translation>
    </message>
    <message>
        <source>Shortest line</source>
        <translation>Kortste lijn</translation>
    </message>
    <message>
        <source>Shorter pieces of lines are left out; in 1/720 of the picture&apos;s height</source>
        <translation>Kortere stukjes lijn vallen weg; in 1/720 van de hoogte van het beeld</translation>
    </message>
    <message>
        <source>Line scale</source>
        <translation>Lijnschaal</translation>
    </message>
    <message>
        <source>How large a form must be to get suggestive contours, times the usual; 0 draws all that were measured</source>
        <translation>Hoe groot een vorm moet zijn voor suggestieve contouren, keer het gebruikelijke; 0 tekent alle gemeten</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>Halo</translation>
    </message>
    <message>
        <source>How many line widths before its outline lines behind stop</source>
        <translation>Hoeveel lijnbreedten voor de omtrek lijnen erachter ophouden</translation>
    </message>
    <message>
        <source>Pencil grain</source>
        <translation>Potloodkorrel</translation>
    </message>
    <message>
        <source>How much the pen is a pencil on rough paper</source>
        <translation>Hoeveel de pen een potlood op ruw papier is</translation>
    </message>
    <message>
        <source>Hidden outlines</source>
        <translation>Verborgen omtrekken</translation>
    </message>
    <message>
        <source>How outlines are drawn where other structures hide them</source>
        <translation>Hoe omtrekken worden getekend waar andere structuren ze verbergen</translation>
    </message>
    <message>
        <source>Not drawn</source>
        <translation>Niet getekend</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dun</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestreept</translation>
    </message>
    <message>
        <source>Other Sub&amp;jects…</source>
        <translation>Onderwerpen k&amp;iezen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+J</source>
        <translation>Ctrl+Shift+J</translation>
    </message>
    <message>
        <source>Small plates of the next three subjects, to choose from</source>
        <translation>Kleine platen van de volgende drie onderwerpen om uit te kiezen</translation>
    </message>
    <message>
        <source>drawn without the steps of slices %1 mm apart, at most %2 mm off</source>
        <translation>getekend zonder de treden van plakken op %1 mm afstand, hoogstens %2 mm ernaast</translation>
    </message>
    <message>
        <source>What the scene is about shaded in colour, everything else as quiet context.</source>
        <translation>Waar de scène over gaat in kleur geschaduwd, al het andere als rustige context.</translation>
    </message>
    <message>
        <source>Even Pen</source>
        <translation>Egale pen</translation>
    </message>
    <message>
        <source>Outlines and folds in black, all by one pen that never changes its width.</source>
        <translation>Omtrekken en plooien in zwart, alle met één pen die nooit van breedte verandert.</translation>
    </message>
    <message>
        <source>Textbook</source>
        <translation>Leerboek</translation>
    </message>
    <message>
        <source>Two colours: black lines, and one colour with a pale tint for what the scene is about.</source>
        <translation>Twee kleuren: zwarte lijnen, en één kleur met een bleke tint voor waar de scène over gaat.</translation>
    </message>
    <message>
        <source>Woodcut</source>
        <translation>Houtsnede</translation>
    </message>
    <message>
        <source>Heavy black lines and dense hatching on white.</source>
        <translation>Zware zwarte lijnen en dichte arcering op wit.</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Potlood</translation>
    </message>
    <message>
        <source>Fine strokes of graphite on warm paper.</source>
        <translation>Fijne grafietstreken op warm papier.</translation>
    </message>
    <message>
        <source>Operating Note</source>
        <translation>OK-schets</translation>
    </message>
    <message>
        <source>A few long lines as a surgeon would sketch them, what matters in one colour.</source>
        <translation>Enkele lange lijnen zoals een chirurg ze zou schetsen, wat ertoe doet in één kleur.</translation>
    </message>
    <message>
        <source>Lecture Hall</source>
        <translation>Collegezaal</translation>
    </message>
    <message>
        <source>Bright colours on a dark ground, to be seen from the last row.</source>
        <translation>Heldere kleuren op een donkere ondergrond, te zien vanaf de laatste rij.</translation>
    </message>
    <message>
        <source>What lies inside</source>
        <translation>Wat erin ligt</translation>
    </message>
    <message>
        <source>&amp;All Panels</source>
        <translation>&amp;Alle panelen</translation>
    </message>
    <message>
        <source>F12</source>
        <translation>F12</translation>
    </message>
    <message>
        <source>Hide all panels around the picture, or show them again</source>
        <translation>Alle panelen rond het beeld verbergen, of weer tonen</translation>
    </message>
    <message>
        <source>S&amp;elect</source>
        <translation>Selec&amp;teren</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Alles</translation>
    </message>
    <message>
        <source>Select all structures that are shown and not locked</source>
        <translation>Alle structuren kiezen die getoond worden en niet vergrendeld zijn</translation>
    </message>
    <message>
        <source>&amp;Inverse</source>
        <translation>&amp;Omgekeerd</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Select what is shown and not selected, in place of what is</source>
        <translation>Kiezen wat getoond wordt en niet gekozen is, in plaats van wat dat wel is</translation>
    </message>
    <message>
        <source>Same &amp;Kind</source>
        <translation>Zelfde &amp;soort</translation>
    </message>
    <message>
        <source>Shift+G</source>
        <translation>Shift+G</translation>
    </message>
    <message>
        <source>Select what differs from the selected by side or number alone, such as all ribs; again: all of their system</source>
        <translation>Kiezen wat alleen door kant of nummer van het gekozene verschilt, zoals alle ribben; nog eens: alles in hun stelsel</translation>
    </message>
    <message>
        <source>&amp;Other Side</source>
        <translation>Andere &amp;kant</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Select what the selected structures are paired with on the other side of the body</source>
        <translation>De tegenhangers van de gekozen structuren aan de andere kant van het lichaam kiezen</translation>
    </message>
    <message>
        <source>By a &amp;Box</source>
        <translation>Met een ka&amp;der</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Drag a box in the picture: to the right what lies within, to the left what it touches</source>
        <translation>Een kader in de afbeelding trekken: naar rechts wat erin ligt, naar links wat het raakt</translation>
    </message>
    <message>
        <source>Middle click, Page Down, %1</source>
        <translation>Klik met de middelste knop, Page Down, %1</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Select the next structure before it</source>
        <translation>De volgende structuur ervoor kiezen</translation>
    </message>
    <message>
        <source>Select by a box: to the right what lies within, to the left what it touches; with Ctrl in addition</source>
        <translation>Met een kader kiezen: naar rechts wat erin ligt, naar links wat het raakt; met Ctrl erbij</translation>
    </message>
    <message>
        <source>What can be done with the structure there, and all that lies there from front to back</source>
        <translation>Wat met de structuur daar gedaan kan worden, en alles wat daar ligt van voor naar achter</translation>
    </message>
    <message>
        <source>Serves %1</source>
        <translation>Verzorgt: %1</translation>
    </message>
    <message>
        <source>English / Latin</source>
        <translation>Engels / Latijn</translation>
    </message>
    <message>
        <source>German / Latin</source>
        <translation>Duits / Latijn</translation>
    </message>
    <message>
        <source>Dutch / Latin</source>
        <translation>Nederlands / Latijn</translation>
    </message>
    <message>
        <source>Norwegian / Latin</source>
        <translation>Noors / Latijn</translation>
    </message>
    <message>
        <source>St&amp;yle</source>
        <translation>Sti&amp;jl</translation>
    </message>
    <message>
        <source>&amp;Copy Style</source>
        <translation>Stijl &amp;kopiëren</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>The whole look of the selected structure, for others</source>
        <translation>Het hele uiterlijk van de gekozen structuur, voor andere</translation>
    </message>
    <message>
        <source>&amp;Paste Style</source>
        <translation>Stijl &amp;plakken</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied</source>
        <translation>De gekozen structuren het gekopieerde uiterlijk geven</translation>
    </message>
    <message>
        <source>Paste Style, &amp;Keep Colour</source>
        <translation>Stijl plakken, kle&amp;ur behouden</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+V</source>
        <translation>Ctrl+Alt+Shift+V</translation>
    </message>
    <message>
        <source>Give the selected structures the look that was copied, but for colour and ink</source>
        <translation>De gekozen structuren het gekopieerde uiterlijk geven, zonder kleur en inkt</translation>
    </message>
    <message>
        <source>&amp;Make Like…</source>
        <translation>&amp;Maken zoals…</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>Click on another structure, in the picture or the list: the selected ones are drawn as it is and keep their colours</source>
        <translation>Op een andere structuur klikken, in de afbeelding of de lijst: de gekozene worden getekend zoals die en houden hun kleuren</translation>
    </message>
    <message numerus="yes">
        <source>%n labels point with a dashed line to what is hidden in this picture: %1.</source>
        <translation>
            <numerusform>%n label wijst met een streeplijn naar iets dat in dit beeld verborgen is: %1.</numerusform>
            <numerusform>%n labels wijzen met een streeplijn naar iets dat in dit beeld verborgen is: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that shows it, or draw less of what is before it.</source>
        <translation>Kies een aanzicht dat het toont, of teken minder van wat ervoor ligt.</translation>
    </message>
    <message>
        <source>Where a file says nothing of how it looks: a plate draws what it is about in detail and everything else as context, the other styles in their manner</source>
        <translation>Waar een bestand niet zegt hoe het eruitziet: een plaat tekent waar het om gaat in detail en al het andere als context, de andere stijlen op hun manier</translation>
    </message>
    <message>
        <source>Hi&amp;dden Outlines</source>
        <translation>Ver&amp;borgen omtrekken</translation>
    </message>
    <message>
        <source>&amp;Not Drawn</source>
        <translation>&amp;Niet getekend</translation>
    </message>
    <message>
        <source>Outlines of the selected end where other structures hide them</source>
        <translation>Omtrekken van de selectie houden op waar andere structuren ze verbergen</translation>
    </message>
    <message>
        <source>&amp;Thin</source>
        <translation>&amp;Dun</translation>
    </message>
    <message>
        <source>Outlines of the selected go on thinly where other structures hide them</source>
        <translation>Omtrekken van de selectie gaan dun verder waar andere structuren ze verbergen</translation>
    </message>
    <message>
        <source>&amp;Dashed</source>
        <translation>&amp;Gestreept</translation>
    </message>
    <message>
        <source>Outlines of the selected go on dashed where other structures hide them</source>
        <translation>Omtrekken van de selectie gaan gestreept verder waar andere structuren ze verbergen</translation>
    </message>
    <message>
        <source>Hidden Outlines</source>
        <translation>Verborgen omtrekken</translation>
    </message>
    <message>
        <source>Keep unsaved work</source>
        <translation>Niet-opgeslagen werk bewaren</translation>
    </message>
    <message>
        <source>Each change is kept at once, and offered after a crash</source>
        <translation>Elke wijziging wordt meteen bewaard en na een crash aangeboden</translation>
    </message>
    <message>
        <source>%1 seconds, %2 × %3 pixels, %4 pictures a second.</source>
        <translation>%1 seconden, %2 × %3 pixels, %4 beelden per seconde.</translation>
    </message>
    <message>
        <source>Its size is being measured.</source>
        <translation>De grootte wordt gemeten.</translation>
    </message>
    <message>
        <source>About %1.</source>
        <translation>Ongeveer %1.</translation>
    </message>
    <message>
        <source>About %1 each.</source>
        <translation>Elk ongeveer %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures found no room in the legend: %1.</source>
        <translation>
            <numerusform>%n structuur vond geen plaats in de legenda: %1.</numerusform>
            <numerusform>%n structuren vonden geen plaats in de legenda: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The legend is empty: nothing that is shown has a label, or is in focus.</source>
        <translation>De legenda is leeg: niets van wat getoond wordt heeft een label of is in focus.</translation>
    </message>
    <message>
        <source>Take a larger page or smaller letters, or list fewer.</source>
        <translation>Neem een grotere pagina of kleinere letters, of noem er minder.</translation>
    </message>
    <message>
        <source>Let it list all structures.</source>
        <translation>Laat haar alle structuren noemen.</translation>
    </message>
    <message>
        <source>The sheet labels what is seen.</source>
        <translation>Het blad labelt wat te zien is.</translation>
    </message>
    <message>
        <source>Nowhere to be seen in this picture: its leader is dashed.</source>
        <translation>Nergens in dit beeld te zien: de lijn erheen is gestreept.</translation>
    </message>
    <message>
        <source>The place set by hand is hidden in this picture: its leader is dashed.</source>
        <translation>De met de hand gekozen plaats is in dit beeld verborgen: de lijn erheen is gestreept.</translation>
    </message>
    <message>
        <source>Not in this picture: there is no room for it.</source>
        <translation>Niet in dit beeld: er is geen ruimte voor.</translation>
    </message>
    <message>
        <source>Not in this picture: its place is beyond the edge.</source>
        <translation>Niet in dit beeld: de plaats ligt buiten de rand.</translation>
    </message>
    <message>
        <source>Not in this picture: nothing is drawn at its place.</source>
        <translation>Niet in dit beeld: op deze plaats is niets getekend.</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Techniek</translation>
    </message>
    <message>
        <source>ConFIS</source>
        <translation>ConFIS</translation>
    </message>
    <message>
        <source>Apparent ridges</source>
        <translation>Schijnbare richels</translation>
    </message>
    <message>
        <source>Ridges and valleys</source>
        <translation>Richels en dalen</translation>
    </message>
    <message>
        <source>Photic extremum lines</source>
        <translation>Fotische extreemlijnen</translation>
    </message>
    <message>
        <source>Laplacian lines</source>
        <translation>Laplace-lijnen</translation>
    </message>
    <message>
        <source>Demarcating curves</source>
        <translation>Scheidingskrommen</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanslijnen</translation>
    </message>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ over het oppervlak</translation>
    </message>
    <message>
        <source>Thresholds of lines</source>
        <translation>Drempels van lijnen</translation>
    </message>
    <message>
        <source>Highlight lines</source>
        <translation>Glanslijnen</translation>
    </message>
    <message>
        <source>Dκr·F² must be above</source>
        <translation>Dκr·F² moet erboven liggen</translation>
    </message>
    <message>
        <source>acos(nv) must be above, radians</source>
        <translation>acos(nv) moet erboven liggen, radialen</translation>
    </message>
    <message>
        <source>T/F_c, the thickness of the contour&apos;s margin</source>
        <translation>T/F_c, de dikte van de rand langs de contour</translation>
    </message>
    <message>
        <source>|H|·F_c must be above where H has an extremum</source>
        <translation>|H|·F_c moet erboven liggen waar H een extremum heeft</translation>
    </message>
    <message>
        <source>the least distance between lines, 1/720 of the picture&apos;s height</source>
        <translation>de kleinste afstand tussen lijnen, 1/720 van de beeldhoogte</translation>
    </message>
    <message>
        <source>q1·F must be above</source>
        <translation>q1·F moet erboven liggen</translation>
    </message>
    <message>
        <source>|κ1|·F must be above</source>
        <translation>|κ1|·F moet erboven liggen</translation>
    </message>
    <message>
        <source>|κ1&apos;&apos;|/|κ1|³ across the line must be above</source>
        <translation>|κ1&apos;&apos;|/|κ1|³ dwars op de lijn moet erboven liggen</translation>
    </message>
    <message>
        <source>|∇f|·F must be above</source>
        <translation>|∇f|·F moet erboven liggen</translation>
    </message>
    <message>
        <source>C(g,g,g)·F² must be above</source>
        <translation>C(g,g,g)·F² moet erboven liggen</translation>
    </message>
    <message>
        <source>−Dκr·F² must be above</source>
        <translation>−Dκr·F² moet erboven liggen</translation>
    </message>
    <message>
        <source>κ1²·F² must be above</source>
        <translation>κ1²·F² moet erboven liggen</translation>
    </message>
    <message>
        <source>Compare Tec&amp;hniques…</source>
        <translation>Technieken ver&amp;gelijken…</translation>
    </message>
    <message>
        <source>See what is selected, or all, drawn by several line techniques side by side, and save that as a sheet</source>
        <translation>Wat is gekozen, of alles, in verschillende lijntechnieken naast elkaar zien en als blad bewaren</translation>
    </message>
    <message numerus="yes">
        <source>%n structures are drawn without noise, which is made of pixels: %1.</source>
        <translation>
            <numerusform>%n structuur is zonder ruis getekend, die uit pixels bestaat: %1.</numerusform>
            <numerusform>%n structuren zijn zonder ruis getekend, die uit pixels bestaat: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export a picture, or take streamline hatching.</source>
        <translation>Exporteer een afbeelding of neem stroomlijnarcering.</translation>
    </message>
    <message>
        <source>What draws the form within contours: suggestive contours and hatching, or short streamlines along contours and where the curvature has an extremum, or lines, streamlines and noise that these are compared with</source>
        <translation>Wat de vorm binnen de contouren tekent: suggestieve contouren en arcering, korte stroomlijnen langs contouren en waar de kromming een extremum heeft, of lijnen, stroomlijnen en ruis waarmee deze worden vergeleken</translation>
    </message>
    <message>
        <source>Streamline hatching</source>
        <translation>Stroomlijnarcering</translation>
    </message>
    <message>
        <source>Noise LIC</source>
        <translation>Ruis-LIC</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Schilderen</translation>
    </message>
    <message>
        <source>Focus by Nearness</source>
        <translation>Focus naar nabijheid</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Het geselecteerde met schaduw, al het andere minder uitgewerkt naarmate het verder weg is</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nabijheid van een plaats</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Klik in het beeld om de plaats te zetten, en versleep haar; met Shift in de diepte</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Penseel</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Paint on the selected structures where more is to be told than elsewhere</source>
        <translation>Schilder op de geselecteerde structuren waar meer te vertellen is dan elders</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation>&amp;Kleiner penseel</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>Paint with a smaller brush</source>
        <translation>Schilder met een kleiner penseel</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>&amp;Groter penseel</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>Paint with a larger brush</source>
        <translation>Schilder met een groter penseel</translation>
    </message>
    <message>
        <source>&amp;Erase with the Brush</source>
        <translation>&amp;Wissen met het penseel</translation>
    </message>
    <message>
        <source>Take away what is painted (Ctrl while you paint)</source>
        <translation>Neem weg wat geschilderd is (Ctrl tijdens het schilderen)</translation>
    </message>
    <message>
        <source>the distance between lines in full shade, 1/720 of the picture&apos;s height</source>
        <translation>de afstand tussen lijnen in de volle schaduw, 1/720 van de hoogte van het beeld</translation>
    </message>
    <message>
        <source>the shade must be above, 0 in the light to 1</source>
        <translation>de schaduw moet erboven liggen, 0 in het licht tot 1</translation>
    </message>
    <message numerus="yes">
        <source>%n slides, one for each saved view.</source>
        <translation>
            <numerusform>%n dia, één voor elk bewaard aanzicht.</numerusform>
            <numerusform>%n dia&apos;s, één voor elk bewaard aanzicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, labels as text and lines.</source>
        <translation>%1, labels als tekst en lijnen.</translation>
    </message>
    <message>
        <source>Names, and the views&apos; texts and notes, are in the file as the scene has them. No paths, user names, dates or patient data are.</source>
        <translation>Namen, en teksten en notities van de aanzichten, staan in het bestand zoals de scène ze heeft. Paden, gebruikersnamen, datums en patiëntgegevens niet.</translation>
    </message>
    <message>
        <source>Fi&amp;gure of Several Panels…</source>
        <translation>Figuur met meer &amp;vakken…</translation>
    </message>
    <message>
        <source>Lay saved views out as panels a, b, c on a page for a journal, with insets, scale bars and one legend</source>
        <translation>Opgeslagen aanzichten als vakken a, b, c op een pagina voor een tijdschrift zetten, met uitsneden, schaalbalken en één legenda</translation>
    </message>
    <message numerus="yes">
        <source>%n files, one for each saved view: %1 … %2.</source>
        <translation>
            <numerusform>%n bestand, één voor elk bewaard aanzicht: %1 … %2.</numerusform>
            <numerusform>%n bestanden, één voor elk bewaard aanzicht: %1 … %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 views on about %n pages, with contents, index and bookmarks.</source>
        <translation>
            <numerusform>%1 aanzichten op ongeveer %n pagina, met inhoud, register en bladwijzers.</numerusform>
            <numerusform>%1 aanzichten op ongeveer %n pagina’s, met inhoud, register en bladwijzers.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards, in a deck for each view.</source>
        <translation>
            <numerusform>Ten hoogste %n kaart, in een stapel voor elk aanzicht.</numerusform>
            <numerusform>Ten hoogste %n kaarten, in een stapel voor elk aanzicht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n cards.</source>
        <translation>
            <numerusform>Ten hoogste %n kaart.</numerusform>
            <numerusform>Ten hoogste %n kaarten.</numerusform>
        </translation>
    </message>
    <message>
        <source>What is seen is also told in words, for who does not see it.</source>
        <translation>Wat te zien is, staat er ook in woorden in, voor wie het niet ziet.</translation>
    </message>
    <message>
        <source>The page has %1 million triangles, too many for telephones.</source>
        <translation>De pagina heeft %1 miljoen driehoeken, te veel voor telefoons.</translation>
    </message>
    <message>
        <source>Surfaces are simplified and off by %1 mm at most, which the page says.</source>
        <translation>Oppervlakken zijn vereenvoudigd en wijken hooguit %1 mm af; dat zegt de pagina.</translation>
    </message>
    <message>
        <source>The quiz asks nothing, as no label is to be asked for.</source>
        <translation>De quiz vraagt niets, want er is geen label om naar te vragen.</translation>
    </message>
    <message>
        <source>Let surfaces be off by 0.2 mm, or export less.</source>
        <translation>Laat oppervlakken 0,2 mm afwijken, of exporteer minder.</translation>
    </message>
    <message>
        <source>Label structures, or choose no quiz.</source>
        <translation>Label structuren, of kies geen quiz.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n questions with pictures.</source>
        <translation>
            <numerusform>Hoogstens %n vraag met een afbeelding.</numerusform>
            <numerusform>Hoogstens %n vragen met afbeeldingen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No name of a structure can be read in the file; answers are there as checksums. No paths, user names, dates or patient data are.</source>
        <translation>Geen naam van een structuur is in het bestand te lezen; antwoorden staan er als controlegetallen in. Paden, gebruikersnamen, datums en patiëntgegevens niet.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as one does not see there what is named: %1.</source>
        <translation>
            <numerusform>%n label wordt niet gevraagd, omdat men daar niet ziet wat het benoemt: %1.</numerusform>
            <numerusform>%n labels worden niet gevraagd, omdat men daar niet ziet wat ze benoemen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Vessel, nerve or duct</source>
        <translation>Vat, zenuw of kanaal</translation>
    </message>
    <message>
        <source>Vessels, nerves and ducts</source>
        <translation>Vaten, zenuwen en kanalen</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 and %n more</source>
        <translation>
            <numerusform>%1: %2 en nog %n</numerusform>
            <numerusform>%1: %2 en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n patients. Put them into one scene?</source>
        <translation>
            <numerusform>Deze bestanden zijn van %n patiënt. In één scène zetten?</numerusform>
            <numerusform>Deze bestanden zijn van %n patiënten. In één scène zetten?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>These files are of %n studies, and nothing says that they are of one patient. Put them into one scene?</source>
        <translation>
            <numerusform>Deze bestanden zijn van %n studie, en niets zegt dat ze van één patiënt zijn. In één scène zetten?</numerusform>
            <numerusform>Deze bestanden zijn van %n studies, en niets zegt dat ze van één patiënt zijn. In één scène zetten?</numerusform>
        </translation>
    </message>
    <message>
        <source>Import Together</source>
        <translation>Samen importeren</translation>
    </message>
    <message>
        <source>Only the First</source>
        <translation>Alleen de eerste</translation>
    </message>
    <message>
        <source>Something in it is at fault and was left out: %1</source>
        <translation>Iets erin is fout en is weggelaten: %1</translation>
    </message>
    <message numerus="yes">
        <source>Something in it is at fault and was left out: %1; and %n more</source>
        <translation>
            <numerusform>Iets erin is fout en is weggelaten: %1; en nog %n</numerusform>
            <numerusform>Iets erin is fout en is weggelaten: %1; en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>A newer version of the program has written it; what is unknown here is not shown, and a copy is saved in the form of this version</source>
        <translation>Een nieuwere versie van het programma heeft het geschreven; wat hier onbekend is, wordt niet getoond, en een kopie wordt in de vorm van deze versie opgeslagen</translation>
    </message>
    <message>
        <source>It has changed since the program ended with these changes unsaved</source>
        <translation>Het is gewijzigd sinds het programma eindigde terwijl deze wijzigingen niet waren opgeslagen</translation>
    </message>
    <message>
        <source>Whether it has changed since the program ended is not known</source>
        <translation>Of het is gewijzigd sinds het programma eindigde, is niet bekend</translation>
    </message>
    <message>
        <source>Left and Ri&amp;ght</source>
        <translation>&amp;Links en rechts</translation>
    </message>
    <message>
        <source>Sides Are &amp;Right</source>
        <translation>Zijden &amp;kloppen</translation>
    </message>
    <message>
        <source>What was assumed of left and right is so; marks lose their question marks</source>
        <translation>Wat over links en rechts is aangenomen klopt; de tekens verliezen hun vraagtekens</translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation>Links en rechts &amp;spiegelen</translation>
    </message>
    <message>
        <source>Left and right are swapped, front and back are not: the scene becomes its mirror image</source>
        <translation>Links en rechts zijn verwisseld, voor en achter niet: de scène wordt haar spiegelbeeld</translation>
    </message>
    <message>
        <source>&amp;Turn About the Body&apos;s Axis</source>
        <translation>Om de lichaamsas &amp;draaien</translation>
    </message>
    <message>
        <source>Left and right are swapped, and front and back, too, as where RAS was taken for LPS: half a turn</source>
        <translation>Links en rechts zijn verwisseld, en voor en achter ook, zoals waar RAS voor LPS is aangezien: een halve draai</translation>
    </message>
    <message>
        <source>%1, of the smoothed surface</source>
        <translation>%1, van het gladgemaakte oppervlak</translation>
    </message>
    <message>
        <source>Hide the selected structures</source>
        <translation>De gekozen structuren verbergen</translation>
    </message>
    <message>
        <source>In &amp;Focus</source>
        <translation>In &amp;focus</translation>
    </message>
    <message>
        <source>Select what is in focus</source>
        <translation>Kiezen wat in focus is</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>the view&apos;s text</source>
        <translation>de tekst van het aanzicht</translation>
    </message>
    <message>
        <source>what Γ follows</source>
        <translation>wat Γ volgt</translation>
    </message>
    <message>
        <source>The picture ends %1 mm above its foot, as what is written there has no other room.</source>
        <translation>Het beeld eindigt %1 mm boven zijn onderrand, omdat wat daar staat geen andere plaats heeft.</translation>
    </message>
    <message>
        <source>Choose a view that leaves room, or leave words or credits out.</source>
        <translation>Kies een aanzicht dat ruimte laat, of laat tekst of bronnen weg.</translation>
    </message>
    <message>
        <source>what is open</source>
        <translation>wat open is</translation>
    </message>
    <message>
        <source>or</source>
        <comment>between two wishes of the filter</comment>
        <translation>of</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Zijde</translation>
    </message>
    <message>
        <source>another than its name says</source>
        <translation>een andere dan de naam zegt</translation>
    </message>
    <message>
        <source>The file does not say whose work its surfaces are, as their terms ask: %1.</source>
        <translation>Het bestand zegt niet van wie de oppervlakken zijn, wat hun licentie vraagt: %1.</translation>
    </message>
    <message>
        <source>The subtitles are empty, as no view says anything.</source>
        <translation>De ondertitels zijn leeg, want geen enkel aanzicht zegt iets.</translation>
    </message>
    <message>
        <source>Let it say them in a line, or say them where it is published.</source>
        <translation>Laat het in een regel zeggen, of zeg het waar het bestand verschijnt.</translation>
    </message>
    <message>
        <source>Write what views say.</source>
        <translation>Schrijf wat aanzichten zeggen.</translation>
    </message>
    <message numerus="yes">
        <source>%n labels stand on anatomy, which leaves no room beside it: %1.</source>
        <translation>
            <numerusform>%n label staat op anatomie, die ernaast geen ruimte laat: %1.</numerusform>
            <numerusform>%n labels staan op anatomie, die ernaast geen ruimte laat: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a view that leaves some, a larger page or smaller letters.</source>
        <translation>Kies een aanzicht dat ruimte laat, een groter blad of kleinere letters.</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 ervandaan</translation>
    </message>
    <message>
        <source>%1 (right–left, front–back, foot–head)</source>
        <translation>%1 (rechts–links, voor–achter, voet–hoofd)</translation>
    </message>
    <message>
        <source>%1 (x, y, z)</source>
        <translation>%1 (x, y, z)</translation>
    </message>
    <message>
        <source>Anatomy leaves no ground for names: the drawing ends at a frame, %1 mm within the page&apos;s left and right edge.</source>
        <translation>De anatomie laat de namen geen ruimte: de tekening eindigt bij een kader, %1 mm binnen de linker- en rechterrand van de pagina.</translation>
    </message>
    <message>
        <source>Choose a view from farther away, or no labels.</source>
        <translation>Kies een aanzicht van verder weg, of geen labels.</translation>
    </message>
    <message numerus="yes">
        <source>Names tell that these files are of %n bodies. Put them into one scene?</source>
        <translation>
            <numerusform>Volgens de namen horen deze bestanden bij %n lichaam. In één scène zetten?</numerusform>
            <numerusform>Volgens de namen horen deze bestanden bij %n lichamen. In één scène zetten?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels are not asked for, as what they name may lie on the other side: %1.</source>
        <translation>
            <numerusform>Naar %n label wordt niet gevraagd, omdat het benoemde aan de andere kant kan liggen: %1.</numerusform>
            <numerusform>Naar %n labels wordt niet gevraagd, omdat het benoemde aan de andere kant kan liggen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Say that names are right, or give it another name.</source>
        <translation>Zeg dat de namen kloppen, of geef het een andere naam.</translation>
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
    <name>sline::widgets::AnatomyPalette</name>
    <message>
        <source>Anatomical colours</source>
        <translation>Anatomische kleuren</translation>
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
        <translation>Soort</translation>
    </message>
    <message>
        <source>Points at</source>
        <translation>Wijst naar</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Getoond</translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation>Niet getoond</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Labeltekst wijzigen</translation>
    </message>
    <message>
        <source>Show Label</source>
        <translation>Label tonen</translation>
    </message>
    <message>
        <source>Hide Label</source>
        <translation>Label verbergen</translation>
    </message>
    <message>
        <source>Says (%1)</source>
        <translation>Tekst (%1)</translation>
    </message>
    <message>
        <source>Says (scene’s own)</source>
        <translation>Tekst (van de scène)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::AnnotationsPanel</name>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Take this label away</source>
        <translation>Dit label weghalen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>What the label says</source>
        <translation>Wat het label zegt</translation>
    </message>
    <message>
        <source>Kind of label</source>
        <translation>Soort label</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kleur</translation>
    </message>
    <message>
        <source>Of the dot at its place</source>
        <translation>Van de stip op zijn plaats</translation>
    </message>
    <message>
        <source>As the &amp;Ink</source>
        <translation>Zoals de &amp;inkt</translation>
    </message>
    <message>
        <source>Colour of a Label</source>
        <translation>Kleur van een label</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Kleur…</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vergrendeld</translation>
    </message>
    <message>
        <source>The mouse does not move it</source>
        <translation>De muis verplaatst het niet</translation>
    </message>
    <message>
        <source>Lock Label</source>
        <translation>Label vergrendelen</translation>
    </message>
    <message>
        <source>Unlock Label</source>
        <translation>Label ontgrendelen</translation>
    </message>
    <message>
        <source>Place by Itself</source>
        <translation>Zelf plaatsen</translation>
    </message>
    <message>
        <source>It finds its place again, after it was moved by hand</source>
        <translation>Het vindt zelf weer een plaats, nadat het met de hand is verplaatst</translation>
    </message>
    <message>
        <source>Place Label by Itself</source>
        <translation>Label zelf plaatsen</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Label verwijderen</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Labeltekst wijzigen</translation>
    </message>
    <message>
        <source>Kind of Label</source>
        <translation>Soort label</translation>
    </message>
    <message>
        <source>Choose a label</source>
        <translation>Kies een label</translation>
    </message>
    <message>
        <source>Delete Labels</source>
        <translation>Labels verwijderen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushBar</name>
    <message>
        <source>Brush</source>
        <translation>Penseel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Straal van het penseel ([ en ])</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Zachtheid</translation>
    </message>
    <message>
        <source>How much weaker the brush is towards its rim</source>
        <translation>Hoeveel zwakker het penseel naar de rand toe is</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Sterkte</translation>
    </message>
    <message>
        <source>How much a stroke paints in its middle</source>
        <translation>Hoeveel een streek in het midden schildert</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Wissen</translation>
    </message>
    <message>
        <source>Take away instead (Ctrl while you paint)</source>
        <translation>In plaats daarvan wegnemen (Ctrl tijdens het schilderen)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leegmaken</translation>
    </message>
    <message>
        <source>Take away all that is painted on the selected</source>
        <translation>Neem alles weg wat op het geselecteerde geschilderd is</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Put the brush away (Esc)</source>
        <translation>Leg het penseel weg (Esc)</translation>
    </message>
    <message>
        <source>Clear Paint</source>
        <translation>Schildering leegmaken</translation>
    </message>
    <message>
        <source>Click on what you want to paint on</source>
        <translation>Klik op wat je wilt beschilderen</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n structuur</numerusform>
            <numerusform>%n structuren</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::BrushTool</name>
    <message>
        <source>Erase on %1</source>
        <translation>Wissen op %1</translation>
    </message>
    <message>
        <source>Paint on %1</source>
        <translation>Schilderen op %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ComparisonDialog</name>
    <message>
        <source>&amp;Save Sheet…</source>
        <translation>Blad &amp;bewaren…</translation>
    </message>
    <message>
        <source>Compare Techniques</source>
        <translation>Technieken vergelijken</translation>
    </message>
    <message>
        <source>Su&amp;rface:</source>
        <translation>&amp;Oppervlak:</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Zoals het is</translation>
    </message>
    <message>
        <source>With staircase</source>
        <translation>Met traptreden</translation>
    </message>
    <message>
        <source>With jitter</source>
        <translation>Met ruis</translation>
    </message>
    <message>
        <source>Roughens the surface, to see which techniques bear what segmentation leaves on it</source>
        <translation>Maakt het oppervlak ruw, om te zien welke technieken verdragen wat segmentatie erop achterlaat</translation>
    </message>
    <message>
        <source>Reset &amp;Thresholds</source>
        <translation>&amp;Drempels herstellen</translation>
    </message>
    <message>
        <source>As PDF, SVG or PNG, with what the pictures take and draw</source>
        <translation>Als PDF, SVG of PNG, met wat de beelden kosten en tekenen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 driehoeken</translation>
    </message>
    <message>
        <source>ms: median time to find and join the lines of a view, contours among them, once the surface is prepared.</source>
        <translation>ms: mediaan van de tijd om de lijnen van een aanzicht te vinden en te verbinden, contouren inbegrepen, als het oppervlak is voorbereid.</translation>
    </message>
    <message>
        <source>mm⁻¹: length of the technique&apos;s visible lines, without contours, per area that the model covers, as drawn here.</source>
        <translation>mm⁻¹: lengte van de zichtbare lijnen van de techniek, zonder contouren, per oppervlakte die het model bedekt, zoals hier getekend.</translation>
    </message>
    <message>
        <source>F: radius of the model&apos;s bounding sphere; F_c: its median radius of curvature, at most F; H, κ1: mean curvature, the stronger principal curvature; f: light from the eye.</source>
        <translation>F: straal van de omhullende bol van het model; F_c: zijn mediane kromtestraal, hooguit F; H, κ1: gemiddelde kromming, de sterkste hoofdkromming; f: licht vanuit het oog.</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Blad bewaren</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-tekening (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-beeld (*.png)</translation>
    </message>
    <message>
        <source>Drawing the sheet…</source>
        <translation>Het blad wordt getekend…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 bewaard</translation>
    </message>
    <message>
        <source>Ro&amp;w for each</source>
        <translation>&amp;Rij voor elk</translation>
    </message>
    <message>
        <source>Shows what was selected one below the other, else all of it together</source>
        <translation>Toont het gekozene onder elkaar, anders alles samen</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-afbeelding (*.tiff)</translation>
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
    <message>
        <source>List of structures</source>
        <translation>Lijst van structuren</translation>
    </message>
</context>
<context>
    <name>sline::widgets::CubeMark</name>
    <message>
        <source>Orientation cube</source>
        <translation>Oriëntatiekubus</translation>
    </message>
    <message>
        <source>The keys A, P, L, R, S and I look from the same sides.</source>
        <translation>De toetsen A, P, L, R, S en I kijken van dezelfde kanten.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::DrawingPanel</name>
    <message>
        <source>Drawing Styles</source>
        <translation>Tekenstijlen</translation>
    </message>
    <message>
        <source>Draws the whole scene in one manner</source>
        <translation>Tekent de hele scène op één manier</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Ingeklapt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportActions</name>
    <message>
        <source>The export was stopped</source>
        <translation>Het exporteren is gestopt</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wordt geëxporteerd</translation>
    </message>
    <message numerus="yes">
        <source>Exporting %n files</source>
        <translation>
            <numerusform>%n bestand wordt geëxporteerd</numerusform>
            <numerusform>%n bestanden worden geëxporteerd</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>With the program that this system has for it</source>
        <translation>Met het programma dat dit systeem ervoor heeft</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>Map tonen</translation>
    </message>
    <message>
        <source>Where it was written to</source>
        <translation>Waar het is weggeschreven</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 is geëxporteerd</translation>
    </message>
    <message numerus="yes">
        <source>Exported %n files</source>
        <translation>
            <numerusform>%n bestand is geëxporteerd</numerusform>
            <numerusform>%n bestanden zijn geëxporteerd</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>De afbeelding staat op het klembord</translation>
    </message>
    <message>
        <source>An export is under way. Stop it and close the window?</source>
        <translation>Er wordt geëxporteerd. Stoppen en het venster sluiten?</translation>
    </message>
    <message>
        <source>Stop and Close</source>
        <translation>Stoppen en sluiten</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Doorgaan</translation>
    </message>
    <message>
        <source>Print proof</source>
        <translation>Drukproef</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportDialog</name>
    <message>
        <source>&amp;What the window shows</source>
        <translation>&amp;Wat het venster toont</translation>
    </message>
    <message>
        <source>&amp;Fill the page with what is shown</source>
        <translation>De pagina &amp;vullen met wat te zien is</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exporteren</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Soort bestand</translation>
    </message>
    <message numerus="yes">
        <source>Each sa&amp;ved view, %n files</source>
        <translation>
            <numerusform>Elk &amp;bewaard aanzicht, %n bestand</numerusform>
            <numerusform>Elk &amp;bewaard aanzicht, %n bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves the camera to or fro without turning it</source>
        <translation>Beweegt de camera heen of weer zonder te draaien</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Wat</translation>
    </message>
    <message>
        <source>For this kind</source>
        <translation>Voor deze soort</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Afbeelding</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>At the picture&apos;s edge</source>
        <translation>Aan de rand van de afbeelding</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Pagina</translation>
    </message>
    <message>
        <source>What the file will contain</source>
        <translation>Wat het bestand zal bevatten</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>Be&amp;stand</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Bladeren…</translation>
    </message>
    <message>
        <source>Export To</source>
        <translation>Exporteren naar</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>“%1” bestaat al. Vervangen?</translation>
    </message>
    <message numerus="yes">
        <source>%n of the files are there already. Replace them?</source>
        <translation>
            <numerusform>%n van de bestanden bestaat al. Vervangen?</numerusform>
            <numerusform>%n van de bestanden bestaan al. Vervangen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>In the file&apos;s details</source>
        <translation>In de gegevens van het bestand</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Taal: %1</translation>
    </message>
    <message numerus="yes">
        <source>All %n sa&amp;ved views, in one file</source>
        <translation>
            <numerusform>Het %n &amp;bewaarde aanzicht, in één bestand</numerusform>
            <numerusform>Alle %n &amp;bewaarde aanzichten, in één bestand</numerusform>
        </translation>
    </message>
    <message>
        <source>Each view has a page, a slide or a deck of its own</source>
        <translation>Elk aanzicht heeft een eigen pagina, dia of stapel</translation>
    </message>
    <message>
        <source>A file for each view, with its number and name behind the file&apos;s own</source>
        <translation>Een bestand voor elk aanzicht, met nummer en naam achter die van het bestand</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Voorbeeld</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Tekenen…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureDialog</name>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Add a panel with a view</source>
        <translation>Een vak met een aanzicht toevoegen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Remove the panel</source>
        <translation>Het vak verwijderen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Omhoog</translation>
    </message>
    <message>
        <source>Move the panel up</source>
        <translation>Het vak omhoog</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Omlaag</translation>
    </message>
    <message>
        <source>Move the panel down</source>
        <translation>Het vak omlaag</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporteren…</translation>
    </message>
    <message>
        <source>Figure of Several Panels</source>
        <translation>Figuur met meer vakken</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Pagina</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Vakken</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Openen…</translation>
    </message>
    <message>
        <source>&amp;Save Figure…</source>
        <translation>Figuur op&amp;slaan…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Another Scene…</source>
        <translation>Andere scène…</translation>
    </message>
    <message>
        <source>Open Figure</source>
        <translation>Figuur openen</translation>
    </message>
    <message>
        <source>Figures (*.json)</source>
        <translation>Figuren (*.json)</translation>
    </message>
    <message>
        <source>Add Views of Another Scene</source>
        <translation>Aanzichten van een andere scène toevoegen</translation>
    </message>
    <message>
        <source>Scenes (*.sline)</source>
        <translation>Scènes (*.sline)</translation>
    </message>
    <message>
        <source>Save Figure</source>
        <translation>Figuur opslaan</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 opgeslagen</translation>
    </message>
    <message>
        <source>Export Figure</source>
        <translation>Figuur exporteren</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-tekening (*.svg)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-afbeelding (*.png)</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>De figuur wordt geschreven …</translation>
    </message>
    <message>
        <source>The figure has changes that are in no file.</source>
        <translation>De figuur heeft wijzigingen die in geen bestand staan.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Opslaan…</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerpen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>As PDF, SVG, PNG or TIFF</source>
        <translation>Als PDF, SVG, PNG of TIFF</translation>
    </message>
    <message>
        <source>The page as it was; it is being drawn anew…</source>
        <translation>De pagina zoals die was; ze wordt opnieuw getekend…</translation>
    </message>
    <message>
        <source>The page as it was; %1 has changed</source>
        <translation>De pagina zoals die was; %1 is veranderd</translation>
    </message>
    <message>
        <source>The page as it was before the last change</source>
        <translation>De pagina zoals die voor de laatste wijziging was</translation>
    </message>
    <message>
        <source>TIFF picture (*.tiff)</source>
        <translation>TIFF-afbeelding (*.tiff)</translation>
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
        <translation>&amp;Breedte voor tijdschriften</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>As panels need</source>
        <translation>Zoals de vakken nodig hebben</translation>
    </message>
    <message>
        <source>Colum&amp;ns</source>
        <translation>&amp;Kolommen</translation>
    </message>
    <message>
        <source>&amp;Letters of panels</source>
        <translation>&amp;Letters van vakken</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Geen</translation>
    </message>
    <message>
        <source>Their size</source>
        <translation>Hun grootte</translation>
    </message>
    <message>
        <source>Size of la&amp;bels</source>
        <translation>Grootte van la&amp;bels</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Contouren</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>Le&amp;genda</translation>
    </message>
    <message>
        <source>All structures</source>
        <translation>Alle structuren</translation>
    </message>
    <message>
        <source>What labels point at</source>
        <translation>Waar labels naar wijzen</translation>
    </message>
    <message>
        <source>What is in focus</source>
        <translation>Wat in de focus staat</translation>
    </message>
    <message>
        <source>Per&amp;spective</source>
        <translation>&amp;Perspectief</translation>
    </message>
    <message>
        <source>As views were saved</source>
        <translation>Zoals aanzichten zijn opgeslagen</translation>
    </message>
    <message>
        <source>T&amp;hin lines</source>
        <translation>&amp;Dunne lijnen</translation>
    </message>
    <message>
        <source>Drawn wide enough to print</source>
        <translation>Breed genoeg om te drukken</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Geweigerd</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behouden</translation>
    </message>
    <message>
        <source>Labels in all panels</source>
        <translation>Labels in alle vakken</translation>
    </message>
    <message>
        <source>Scale bars in all panels</source>
        <translation>Schaalbalk in alle vakken</translation>
    </message>
    <message>
        <source>R and L in all panels</source>
        <translation>R en L in alle vakken</translation>
    </message>
    <message>
        <source>Black and white</source>
        <translation>Zwart-wit</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Van voren</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Van achteren</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Van links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Van rechts</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Van boven</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Van onderen</translation>
    </message>
    <message>
        <source>Part of %1</source>
        <translation>Deel van %1</translation>
    </message>
    <message>
        <source>On its panel</source>
        <translation>Op zijn vak</translation>
    </message>
    <message>
        <source>Lines from its frame</source>
        <translation>Lijnen vanaf zijn kader</translation>
    </message>
    <message>
        <source>As its view has it</source>
        <translation>Zoals zijn aanzicht</translation>
    </message>
    <message>
        <source>Fitted to the panel</source>
        <translation>In het vak gepast</translation>
    </message>
    <message>
        <source>Like %1</source>
        <translation>Zoals %1</translation>
    </message>
    <message>
        <source>C&amp;amera</source>
        <translation>C&amp;amera</translation>
    </message>
    <message>
        <source>As its panel</source>
        <translation>Zoals zijn vak</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Aanzicht</translation>
    </message>
    <message>
        <source>Spans columns</source>
        <translation>Over kolommen</translation>
    </message>
    <message>
        <source>Spans rows</source>
        <translation>Over rijen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Schaalbalk</translation>
    </message>
    <message>
        <source>A panel may have a choice of its own</source>
        <translation>Een paneel kan het anders hebben</translation>
    </message>
    <message>
        <source>If not as in the other panels</source>
        <translation>Als het niet is zoals in de andere panelen</translation>
    </message>
    <message>
        <source>One column of a journal, one and a half, or two</source>
        <translation>Eén kolom van een tijdschrift, anderhalve of twee</translation>
    </message>
    <message>
        <source>For pages that no journal prescribes</source>
        <translation>Voor pagina’s die geen tijdschrift voorschrijft</translation>
    </message>
    <message>
        <source>Without it panels are 4 by 3 and the legend has its room</source>
        <translation>Zonder deze zijn panelen 4 bij 3 en heeft de legenda haar plaats</translation>
    </message>
    <message>
        <source>Into how many columns the page is divided; panels fill it by rows</source>
        <translation>In hoeveel kolommen de pagina is verdeeld; panelen vullen haar rij voor rij</translation>
    </message>
    <message>
        <source>Bold, at the upper left of each panel</source>
        <translation>Vet, linksboven in elk paneel</translation>
    </message>
    <message>
        <source>How large the letters of panels are</source>
        <translation>Hoe groot de letters van panelen zijn</translation>
    </message>
    <message>
        <source>How wide contours are, the same in all panels</source>
        <translation>Hoe breed contouren zijn, in alle panelen gelijk</translation>
    </message>
    <message>
        <source>One legend for all panels, at the foot of the page</source>
        <translation>Eén legenda voor alle panelen, onder aan de pagina</translation>
    </message>
    <message>
        <source>Without perspective a scale bar is true everywhere</source>
        <translation>Zonder perspectief klopt een schaalbalk overal</translation>
    </message>
    <message>
        <source>And the other sides of the body</source>
        <translation>En de andere zijden van het lichaam</translation>
    </message>
    <message>
        <source>Ink alone, without tones and colours</source>
        <translation>Alleen inkt, zonder tinten en kleuren</translation>
    </message>
    <message>
        <source>A saved view of the scene, or a side of the body</source>
        <translation>Een bewaard aanzicht van de scène of een zijde van het lichaam</translation>
    </message>
    <message>
        <source>Like another panel: of the same direction and scale, to be compared</source>
        <translation>Zoals een ander paneel: met dezelfde richting en schaal, om te vergelijken</translation>
    </message>
    <message>
        <source>The enlarged part lies on the panel of which it is a part</source>
        <translation>Het vergrote deel ligt op het paneel waarvan het een deel is</translation>
    </message>
    <message>
        <source>From the corners of the frame to those of the enlarged part</source>
        <translation>Van de hoeken van het kader naar die van het vergrote deel</translation>
    </message>
    <message>
        <source>How many columns of the page the panel is wide</source>
        <translation>Hoeveel kolommen van de pagina het paneel breed is</translation>
    </message>
    <message>
        <source>How many rows of the page the panel is high</source>
        <translation>Hoeveel rijen van de pagina het paneel hoog is</translation>
    </message>
    <message>
        <source>How far panels are apart</source>
        <translation>Hoe ver vakken uit elkaar staan</translation>
    </message>
    <message>
        <source>So that sizes compare: one scale bar is true for all panels; enlarged parts stay enlarged</source>
        <translation>Zodat groottes te vergelijken zijn: één schaalbalk geldt voor alle vakken; vergrote delen blijven vergroot</translation>
    </message>
    <message>
        <source>Of labels, scale bars and the legend, as in de, la or de+la; empty: the scene&apos;s own</source>
        <translation>Van labels, schaalbalken en legenda, zoals de, la of de+la; leeg: die van de scène</translation>
    </message>
    <message>
        <source>A figure with smaller ones is refused</source>
        <translation>Een figuur met kleinere wordt geweigerd</translation>
    </message>
    <message>
        <source>What thin lines are measured by</source>
        <translation>Waaraan dunne lijnen worden gemeten</translation>
    </message>
    <message>
        <source>Scale bars and the legend are a fifth smaller</source>
        <translation>Schaalbalken en legenda zijn een vijfde kleiner</translation>
    </message>
    <message>
        <source>What becomes of lines that are too thin to print; hatching stays</source>
        <translation>Wat er gebeurt met lijnen die te dun zijn om te drukken; arcering blijft</translation>
    </message>
    <message>
        <source>Moved aside to the middle of what this panel shows</source>
        <translation>Opzij verplaatst naar het midden van wat dit vak toont</translation>
    </message>
    <message>
        <source>In place of the next one; a blank for none</source>
        <translation>In plaats van de volgende; een spatie voor geen</translation>
    </message>
    <message>
        <source>Between panels</source>
        <translation>Tussen vakken</translation>
    </message>
    <message>
        <source>Smallest letters</source>
        <translation>Kleinste letters</translation>
    </message>
    <message>
        <source>Thinnest lines</source>
        <translation>Dunste lijnen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>Same scale in all panels</source>
        <translation>Zelfde schaal in alle vakken</translation>
    </message>
    <message>
        <source>On its own middle</source>
        <translation>Op het eigen midden</translation>
    </message>
    <message>
        <source>R and L</source>
        <translation>R en L</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigurePreview</name>
    <message>
        <source>The figure</source>
        <translation>De figuur</translation>
    </message>
    <message>
        <source>Drag a rectangle in a panel to show that part enlarged</source>
        <translation>Sleep een rechthoek in een vak om dat deel vergroot te tonen</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wordt getekend…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FigureWriting</name>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Writing the figure…</source>
        <translation>De figuur wordt geschreven…</translation>
    </message>
    <message>
        <source>Stop writing; a file that was there before stays as it is</source>
        <translation>Stoppen met schrijven; een bestand dat er al was, blijft zoals het is</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 opgeslagen</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Gestopt; er is niets geschreven</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FileActions</name>
    <message>
        <source>Untitled</source>
        <translation>Naamloos</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 opslaan…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 opgeslagen</translation>
    </message>
    <message>
        <source>it is no longer there</source>
        <translation>het is er niet meer</translation>
    </message>
    <message>
        <source>Open it from where it is now</source>
        <translation>Open het waar het nu is</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>Kopie opslaan</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Opslaan als</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (alleen-lezen)</translation>
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
        <translation>%1 is alleen-lezen geopend</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Lijst &amp;wissen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FilePager</name>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 van %3)</translation>
    </message>
    <message>
        <source>Preview of what comes before</source>
        <translation>Voorbeeld van het vorige</translation>
    </message>
    <message>
        <source>Preview of what comes next</source>
        <translation>Voorbeeld van het volgende</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusContext</name>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>Focus from this view</source>
        <translation>Focus vanuit dit aanzicht</translation>
    </message>
    <message>
        <source>Focus all round</source>
        <translation>Focus rondom</translation>
    </message>
    <message>
        <source>nothing is left to focus on</source>
        <translation>er blijft niets over voor de focus</translation>
    </message>
    <message>
        <source>Select something that no section takes away</source>
        <translation>Kies iets wat geen doorsnede weghaalt</translation>
    </message>
    <message>
        <source>Role in the context</source>
        <translation>Rol in de context</translation>
    </message>
    <message>
        <source>Hidden structures in the context</source>
        <translation>Verborgen structuren in de context</translation>
    </message>
    <message>
        <source>Context %1 %</source>
        <translation>Context %1 %</translation>
    </message>
    <message>
        <source>Opening look</source>
        <translation>Uiterlijk bij openen</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaat</translation>
    </message>
    <message>
        <source>set by hand since</source>
        <translation>sindsdien met de hand ingesteld</translation>
    </message>
    <message>
        <source>Back to the focus</source>
        <translation>Terug naar de focus</translation>
    </message>
</context>
<context>
    <name>sline::widgets::FocusPanel</name>
    <message>
        <source>As you said</source>
        <translation>Zoals je zei</translation>
    </message>
    <message>
        <source>Focus on Selection</source>
        <translation>Focus op selectie</translation>
    </message>
    <message>
        <source>These in detail, everything else by what it is to them</source>
        <translation>Deze in detail, al het andere naar wat het voor ze is</translation>
    </message>
    <message>
        <source>How much context</source>
        <translation>Hoeveel context</translation>
    </message>
    <message>
        <source>Focus alone</source>
        <translation>Alleen focus</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>All Round</source>
        <translation>Rondom</translation>
    </message>
    <message>
        <source>Nothing hides the focus from whatever side it is seen</source>
        <translation>Niets bedekt de focus, van welke kant ook gezien</translation>
    </message>
    <message>
        <source>This View</source>
        <translation>Dit aanzicht</translation>
    </message>
    <message>
        <source>Nothing hides the focus as it is seen now; what lies behind it may be solid</source>
        <translation>Niets bedekt de focus zoals die nu gezien wordt; wat erachter ligt mag dekkend zijn</translation>
    </message>
    <message>
        <source>What each structure is to the focus</source>
        <translation>Wat elke structuur voor de focus is</translation>
    </message>
    <message>
        <source>Treat as</source>
        <translation>Behandelen als</translation>
    </message>
    <message>
        <source>&amp;Treat as</source>
        <translation>&amp;Behandelen als</translation>
    </message>
    <message>
        <source>Nothing in focus</source>
        <translation>Niets in focus</translation>
    </message>
    <message numerus="yes">
        <source>%n structures in focus</source>
        <translation>
            <numerusform>%n structuur in focus</numerusform>
            <numerusform>%n structuren in focus</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking at what surrounds it…</source>
        <translation>De omgeving wordt bekeken…</translation>
    </message>
    <message>
        <source>Select a structure in the list or in the picture.</source>
        <translation>Kies een structuur in de lijst of in het beeld.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Also what was hidden</source>
        <translation>Ook wat verborgen was</translation>
    </message>
    <message numerus="yes">
        <source>Also %n hidden structures</source>
        <translation>
            <numerusform>Ook %n verborgen structuur</numerusform>
            <numerusform>Ook %n verborgen structuren</numerusform>
        </translation>
    </message>
    <message>
        <source>Set by hand since; the focus leaves it so</source>
        <translation>Sindsdien met de hand ingesteld; de focus laat het zo</translation>
    </message>
    <message>
        <source>%1 – by hand</source>
        <translation>%1 – met de hand</translation>
    </message>
    <message>
        <source>Draws them as the focus would; only those chosen in the list, if any</source>
        <translation>Tekent ze zoals de focus dat zou doen; alleen wat in de lijst gekozen is, als dat er is</translation>
    </message>
    <message numerus="yes">
        <source>%n by Hand: Back to the Focus</source>
        <translation>
            <numerusform>%n met de hand: terug naar de focus</numerusform>
            <numerusform>%n met de hand: terug naar de focus</numerusform>
        </translation>
    </message>
    <message>
        <source>Nearness to a place</source>
        <translation>Nabijheid van een plaats</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaCurve</name>
    <message>
        <source>Curve of Γ</source>
        <translation>Kromme van Γ</translation>
    </message>
    <message>
        <source>What is added to Γ, from left to right along the value. Drag a point; a double click or Insert adds one, Delete takes one away. Arrow keys move the chosen point, Space chooses the next</source>
        <translation>Wat bij Γ komt, van links naar rechts langs de waarde. Sleep een punt; een dubbelklik of Insert voegt er een toe, Delete haalt er een weg. Pijltoetsen verplaatsen het gekozen punt, de spatiebalk kiest het volgende</translation>
    </message>
    <message>
        <source>Point %1 of %2: %3 at %4</source>
        <translation>Punt %1 van %2: %3 bij %4</translation>
    </message>
</context>
<context>
    <name>sline::widgets::GammaMapEditor</name>
    <message>
        <source>Γ over the surface</source>
        <translation>Γ over het oppervlak</translation>
    </message>
    <message>
        <source>Lets Γ vary from place to place on a structure</source>
        <translation>Laat Γ van plaats tot plaats op een structuur verschillen</translation>
    </message>
    <message>
        <source>The same everywhere</source>
        <translation>Overal gelijk</translation>
    </message>
    <message>
        <source>By cavities</source>
        <translation>Naar holten</translation>
    </message>
    <message>
        <source>By curvature</source>
        <translation>Naar kromming</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Naar afstand</translation>
    </message>
    <message>
        <source>Several</source>
        <translation>Meerdere</translation>
    </message>
    <message>
        <source>Distance from</source>
        <translation>Afstand van</translation>
    </message>
    <message>
        <source>The structure or group from which distances are measured</source>
        <translation>De structuur of groep van waaraf afstanden worden gemeten</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Niets</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n onderdeel</numerusform>
            <numerusform>%n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Schilderen…</translation>
    </message>
    <message>
        <source>By painting</source>
        <translation>Naar schildering</translation>
    </message>
    <message>
        <source>Cavities: how much of its own sky the surface hides, 0 to 1. Curvature: 1 on a ball, negative in hollows. Distance: millimetres from another structure. Painting: what you paint in the picture, 0 to 1</source>
        <translation>Holten: hoeveel van zijn eigen hemel het oppervlak verbergt, 0 tot 1. Kromming: 1 op een bol, negatief in kuilen. Afstand: millimeters van een andere structuur. Schildering: wat je in het beeld schildert, 0 tot 1</translation>
    </message>
    <message>
        <source>Paint in the picture with a brush</source>
        <translation>Schilder in het beeld met een penseel</translation>
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
        <source>Inherit Γ</source>
        <translation>Γ overnemen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Vulling</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voorinstellingen</translation>
    </message>
    <message>
        <source>A number that is typed is for all that is selected</source>
        <translation>Een getypt getal geldt voor alles wat geselecteerd is</translation>
    </message>
</context>
<context>
    <name>sline::widgets::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Pagina</translation>
    </message>
    <message>
        <source>Search in help</source>
        <translation>Zoeken in de help</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhoud</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Terug</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vooruit</translation>
    </message>
    <message>
        <source>Open in the Browser?</source>
        <translation>Openen in de browser?</translation>
    </message>
    <message>
        <source>This link leads out of the program, to
%1</source>
        <translation>Deze koppeling leidt buiten het programma, naar
%1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportActions</name>
    <message>
        <source>The Size Is Right</source>
        <translation>De grootte klopt</translation>
    </message>
    <message>
        <source>The size is right</source>
        <translation>De grootte klopt</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>%1 als eenheid nemen</translation>
    </message>
    <message numerus="yes">
        <source>%n structures were read as %1, unlike alone: so they go with the open scene</source>
        <translation>
            <numerusform>%n structuur werd als %1 gelezen, anders dan alleen: zo past ze bij de open scène</numerusform>
            <numerusform>%n structuren werden als %1 gelezen, anders dan alleen: zo passen ze bij de open scène</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importeren</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structuren</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelaten</translation>
    </message>
    <message>
        <source>Filter by name or file</source>
        <translation>Op naam of bestand filteren</translation>
    </message>
    <message>
        <source>What is left out or mended</source>
        <translation>Wat weggelaten of hersteld wordt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>What happened, and what to do</source>
        <translation>Wat er gebeurd is en wat te doen</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Voortgang van het lezen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Opens what is listed as a scene of its own</source>
        <translation>Opent wat in de lijst staat als eigen scène</translation>
    </message>
    <message>
        <source>Add to Scene</source>
        <translation>Aan scène toevoegen</translation>
    </message>
    <message>
        <source>Puts what is listed below the structures of the open scene</source>
        <translation>Zet wat in de lijst staat onder de structuren van de open scène</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Bezig met lezen…</translation>
    </message>
    <message>
        <source>Left out or mended</source>
        <translation>Weggelaten of hersteld</translation>
    </message>
    <message>
        <source>Left out or mended (%1)</source>
        <translation>Weggelaten of hersteld (%1)</translation>
    </message>
    <message>
        <source>Nothing can be imported</source>
        <translation>Er is niets te importeren</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>The Size Is Right</source>
        <translation>De grootte klopt</translation>
    </message>
    <message>
        <source>Take %1 as the Unit</source>
        <translation>%1 als eenheid nemen</translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either</source>
        <translation>Woorden in willekeurige volgorde; “%1” of een komma ertussen vindt elk van beide</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ImportDraft</name>
    <message>
        <source>LPS – left, posterior, superior</source>
        <translation>LPS – links, achter, boven</translation>
    </message>
    <message>
        <source>RAS – right, anterior, superior</source>
        <translation>RAS – rechts, voor, boven</translation>
    </message>
    <message>
        <source>As in the file, unturned</source>
        <translation>Zoals in het bestand, ongedraaid</translation>
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
        <translation>in – inch</translation>
    </message>
    <message>
        <source>µm – micrometres</source>
        <translation>µm – micrometer</translation>
    </message>
    <message>
        <source>Å – ångström</source>
        <translation>Å – ångström</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Uit</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n stap</numerusform>
            <numerusform>%n stappen</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Alles houden</translation>
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
        <translation>uit</translation>
    </message>
    <message>
        <source>within %1 mm</source>
        <translation>binnen %1 mm</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nee</translation>
    </message>
    <message>
        <source>as the scene file has it</source>
        <translation>zoals het scènebestand het heeft</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>; en nog %n</numerusform>
            <numerusform>; en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>onbekend</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>zoals in het bestand</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>‘%1’</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n structures</source>
        <translation>
            <numerusform>%n structuur</numerusform>
            <numerusform>%n structuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n groups</source>
        <translation>
            <numerusform>%n groep</numerusform>
            <numerusform>%n groepen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 driehoeken</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n overgeslagen</numerusform>
            <numerusform>%n overgeslagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Everything together is %1 mm large</source>
        <translation>Alles samen is %1 mm groot</translation>
    </message>
    <message>
        <source>%1. If the files are in %2, it is %3 mm.</source>
        <translation>%1. Als de bestanden in %2 zijn, is het %3 mm.</translation>
    </message>
    <message>
        <source>%1, which is small for anatomy.</source>
        <translation>%1, wat klein is voor anatomie.</translation>
    </message>
    <message>
        <source>%1, which is large for anatomy.</source>
        <translation>%1, wat groot is voor anatomie.</translation>
    </message>
    <message numerus="yes">
        <source>%n structures lie on the other side than their names say: %1.</source>
        <translation>
            <numerusform>%n structuur ligt aan de andere kant dan de naam zegt: %1.</numerusform>
            <numerusform>%n structuren liggen aan de andere kant dan hun namen zeggen: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles, %4</source>
        <translation>%1: %2, %3 driehoeken, %4</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, uit %2</translation>
    </message>
    <message>
        <source>From a scene file: it keeps its place, size and triangles.</source>
        <translation>Uit een scènebestand: het houdt plaats, grootte en driehoeken.</translation>
    </message>
    <message>
        <source>Frame: %1</source>
        <translation>Assenstelsel: %1</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>Eenheid: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n faces mended</source>
        <translation>
            <numerusform>%n vlak hersteld</numerusform>
            <numerusform>%n vlakken hersteld</numerusform>
        </translation>
    </message>
    <message>
        <source>Its name says the other side than it lies on.</source>
        <translation>De naam zegt de andere kant dan waar het ligt.</translation>
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
            <numerusform>Links en rechts lijken verwisseld: %n structuur met een zijde in de naam ligt aan de andere kant (%1).</numerusform>
            <numerusform>Links en rechts lijken verwisseld: alle %n structuren met een zijde in de naam liggen aan de andere kant (%1).</numerusform>
        </translation>
    </message>
    <message>
        <source>Front and back are right: if the files are mirrored, choose %1.</source>
        <translation>Voor en achter kloppen: zijn de bestanden gespiegeld, kies dan %1.</translation>
    </message>
    <message>
        <source>Choose %1.</source>
        <translation>Kies %1.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::IntensityRange</name>
    <message>
        <source>Intensities</source>
        <translation>Intensiteiten</translation>
    </message>
    <message>
        <source>How often each intensity occurs. Drag the bounds; on the keyboard the arrows move the lower one, with Shift the upper one</source>
        <translation>Hoe vaak elke intensiteit voorkomt. Sleep de grenzen; op het toetsenbord verplaatsen de pijlen de onderste, met Shift de bovenste</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelActions</name>
    <message>
        <source>Click on two places to measure between them; Esc ends this</source>
        <translation>Klik op twee plaatsen om ertussen te meten; Esc beëindigt dit</translation>
    </message>
    <message>
        <source>Click on a place to mark it; Esc ends this</source>
        <translation>Klik op een plaats om die te markeren; Esc beëindigt dit</translation>
    </message>
    <message>
        <source>Click on a structure and type; Shift+Return begins a line, Esc ends this</source>
        <translation>Klik op een structuur en typ; Shift+Enter begint een regel, Esc beëindigt dit</translation>
    </message>
    <message>
        <source>Click on a structure and type; Esc ends this</source>
        <translation>Klik op een structuur en typ; Esc beëindigt dit</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message numerus="yes">
        <source>Add %n labels</source>
        <translation>
            <numerusform>%n label toevoegen</numerusform>
            <numerusform>%n labels toevoegen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels added</source>
        <translation>
            <numerusform>%n label toegevoegd</numerusform>
            <numerusform>%n labels toegevoegd</numerusform>
        </translation>
    </message>
    <message>
        <source>What is selected has labels already, or is not in the picture</source>
        <translation>Het geselecteerde heeft al labels, of is niet in beeld</translation>
    </message>
    <message>
        <source>Nothing is there: click on a structure</source>
        <translation>Daar is niets: klik op een structuur</translation>
    </message>
    <message>
        <source>Label added; %1</source>
        <translation>Label toegevoegd; %1</translation>
    </message>
    <message>
        <source>shown in %1 of %2 saved views: the panel Labels says in which</source>
        <translation>getoond in %1 van %2 opgeslagen aanzichten: het paneel ‘Labels’ zegt in welke</translation>
    </message>
    <message numerus="yes">
        <source>%n have no room in this picture: the panel Labels says which</source>
        <translation>
            <numerusform>%n heeft geen plaats in dit beeld: het paneel ‘Labels’ zegt welk</numerusform>
            <numerusform>%n hebben geen plaats in dit beeld: het paneel ‘Labels’ zegt welke</numerusform>
        </translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Afstand toevoegen</translation>
    </message>
    <message>
        <source>The shortest distance between the two selected structures was added; with another selection you choose two places</source>
        <translation>De kortste afstand tussen de twee gekozen structuren is toegevoegd; bij een andere keuze wijs je twee plaatsen aan</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelEditor</name>
    <message>
        <source>What the label says</source>
        <translation>Wat het label zegt</translation>
    </message>
    <message>
        <source>Return takes it over, Shift+Return begins a line, Esc forgets it</source>
        <translation>Enter neemt het over, Shift+Enter begint een regel, Esc vergeet het</translation>
    </message>
    <message>
        <source>Return takes it over, Esc forgets it</source>
        <translation>Enter neemt het over, Esc vergeet het</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelField</name>
    <message>
        <source>**bold** (%1), *italic* (%2); lines that begin with “- ” are a list</source>
        <translation>**vet** (%1), *cursief* (%2); regels die met ‘- ’ beginnen, worden een lijst</translation>
    </message>
    <message>
        <source>In presentations and on students&apos; pages [ureter](#structure=left ureter) lights that structure up, and [from behind](#view=2) goes to a view</source>
        <translation>In presentaties en op pagina’s voor studenten licht [urineleider](#structure=linker urineleider) die structuur op, en gaat [van achteren](#view=2) naar een aanzicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelTool</name>
    <message>
        <source>Move Label</source>
        <translation>Label verplaatsen</translation>
    </message>
    <message>
        <source>Move What a Label Points At</source>
        <translation>Verplaatsen waar een label naar wijst</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LabelViews</name>
    <message>
        <source>Views that show it</source>
        <translation>Aanzichten die het tonen</translation>
    </message>
    <message>
        <source>Which of the saved views show it</source>
        <translation>Welke van de opgeslagen aanzichten het tonen</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Aanzichten</translation>
    </message>
    <message>
        <source>A tick for each saved view that shows what is chosen in the list</source>
        <translation>Een vinkje voor elk opgeslagen aanzicht dat toont wat in de lijst is gekozen</translation>
    </message>
    <message>
        <source>In all views</source>
        <translation>In alle aanzichten</translation>
    </message>
    <message>
        <source>Only in %1</source>
        <translation>Alleen in %1</translation>
    </message>
    <message>
        <source>In different views</source>
        <translation>In verschillende aanzichten</translation>
    </message>
    <message>
        <source>In no view</source>
        <translation>In geen aanzicht</translation>
    </message>
    <message numerus="yes">
        <source>In %n views</source>
        <translation>
            <numerusform>In %n aanzicht</numerusform>
            <numerusform>In %n aanzichten</numerusform>
        </translation>
    </message>
    <message>
        <source>Views of a Label</source>
        <translation>Aanzichten van een label</translation>
    </message>
    <message>
        <source>%1 (some of them)</source>
        <comment>a saved view that shows some of the labels</comment>
        <translation>%1 (sommige ervan)</translation>
    </message>
    <message>
        <source>In All Views</source>
        <translation>In alle aanzichten</translation>
    </message>
    <message>
        <source>In No View</source>
        <translation>In geen aanzicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::LongestText</name>
    <message numerus="yes">
        <source>At most %n characters have room here</source>
        <translation>
            <numerusform>Hier is plaats voor hoogstens %n teken</numerusform>
            <numerusform>Hier is plaats voor hoogstens %n tekens</numerusform>
        </translation>
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
        <translation>Verloop</translation>
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
        <source>Turning around this place on %1</source>
        <translation>Draait om deze plek op %1</translation>
    </message>
    <message>
        <source>Focus and Context</source>
        <translation>Focus en context</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Doorsneden</translation>
    </message>
    <message>
        <source>Structures: %1   Triangles: %2 (refined)</source>
        <translation>Structuren: %1   Driehoeken: %2 (verfijnd)</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ManagePresetsDialog</name>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Hernoemen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Verwijderen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voorinstellingen</translation>
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
    <name>sline::widgets::MorePanel</name>
    <message>
        <source>More</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Open</translation>
    </message>
    <message>
        <source>Folded away</source>
        <translation>Ingeklapt</translation>
    </message>
    <message>
        <source>Lines, hatching, opacity and colours</source>
        <translation>Lijnen, arcering, dekking en kleuren</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearRow</name>
    <message>
        <source>By Nearness</source>
        <translation>Naar nabijheid</translation>
    </message>
    <message>
        <source>Near a Place</source>
        <translation>Bij een plaats</translation>
    </message>
    <message>
        <source>The selected shaded, everything else the less detailed the farther away it is</source>
        <translation>Het geselecteerde met schaduw, al het andere minder uitgewerkt naarmate het verder weg is</translation>
    </message>
    <message>
        <source>Click in the picture to set the place, and drag it; with Shift in depth</source>
        <translation>Klik in het beeld om de plaats te zetten, en versleep haar; met Shift in de diepte</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Bereik</translation>
    </message>
    <message>
        <source>From what distance on there are only silhouettes</source>
        <translation>Vanaf welke afstand er alleen silhouetten zijn</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NearTool</name>
    <message>
        <source>Focus by Nearness</source>
        <translation>Focus naar nabijheid</translation>
    </message>
    <message>
        <source>Reach of Nearness</source>
        <translation>Bereik van nabijheid</translation>
    </message>
    <message>
        <source>Nearness to a Place</source>
        <translation>Nabijheid van een plaats</translation>
    </message>
    <message>
        <source>Move the Place</source>
        <translation>Plaats verschuiven</translation>
    </message>
</context>
<context>
    <name>sline::widgets::NumberLimits</name>
    <message>
        <source>Numbers from %1 to %2 can be set here</source>
        <translation>Hier kunnen getallen van %1 tot %2 worden ingesteld</translation>
    </message>
</context>
<context>
    <name>sline::widgets::OptionsPanel</name>
    <message>
        <source>&amp;Mend faces</source>
        <translation>&amp;Vlakken herstellen</translation>
    </message>
    <message>
        <source>Lay molecules &amp;over each other</source>
        <translation>Moleculen &amp;over elkaar leggen</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Zoals gevonden</translation>
    </message>
    <message>
        <source>Keep all</source>
        <translation>Alles houden</translation>
    </message>
    <message>
        <source>As few triangles as can be with no part of a surface moved by more than this</source>
        <translation>Zo weinig driehoeken als mogelijk zonder dat een deel van een oppervlak meer dan dit verschuift</translation>
    </message>
    <message>
        <source>Leaves out faces without area or given twice, and turns those that look inwards</source>
        <translation>Laat vlakken zonder oppervlakte en dubbele weg, en keert om wat naar binnen kijkt</translation>
    </message>
    <message>
        <source>Coor&amp;dinates</source>
        <translation>Coör&amp;dinaten</translation>
    </message>
    <message>
        <source>&amp;Length of a unit</source>
        <translation>&amp;Lengte van een eenheid</translation>
    </message>
    <message>
        <source>Fewer t&amp;riangles, within</source>
        <translation>Minder d&amp;riehoeken, binnen</translation>
    </message>
    <message>
        <source>S&amp;moothing</source>
        <translation>Glad&amp;maken</translation>
    </message>
    <message>
        <source>Automatic: takes away the steps of label maps, and refines what is too coarse to draw; steps: so much everywhere</source>
        <translation>Automatisch: haalt de treden uit labelmaps en verfijnt wat te grof is om te tekenen; stappen: overal zoveel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Kee&amp;p names</source>
        <translation>Namen &amp;behouden</translation>
    </message>
    <message>
        <source>Names of files, folders and what is in them stay whole; else words that are no anatomy are left out, as they may be a person&apos;s name</source>
        <translation>Namen van bestanden, mappen en wat daarin zit blijven heel; anders vervallen woorden die niet bij de anatomie horen, want ze kunnen de naam van een persoon zijn</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PagePanel</name>
    <message>
        <source>T&amp;urn</source>
        <translation>&amp;Draaien</translation>
    </message>
    <message>
        <source>Reso&amp;lution</source>
        <translation>Reso&amp;lutie</translation>
    </message>
    <message>
        <source>Custom size</source>
        <translation>Eigen formaat</translation>
    </message>
    <message>
        <source>Upright or lying: width and height change places</source>
        <translation>Staand of liggend: breedte en hoogte wisselen van plaats</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hoogte</translation>
    </message>
    <message>
        <source>Unit of width and height</source>
        <translation>Eenheid van breedte en hoogte</translation>
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
        <translation>Groo&amp;tte</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureLabels</name>
    <message>
        <source>Add Callout</source>
        <translation>Bijschrift toevoegen</translation>
    </message>
    <message>
        <source>Add Pin</source>
        <translation>Speld toevoegen</translation>
    </message>
    <message>
        <source>Add Distance</source>
        <translation>Afstand toevoegen</translation>
    </message>
    <message>
        <source>Add Label</source>
        <translation>Label toevoegen</translation>
    </message>
    <message>
        <source>Change What a Label Says</source>
        <translation>Labeltekst wijzigen</translation>
    </message>
    <message>
        <source>Delete Label</source>
        <translation>Label verwijderen</translation>
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
        <translation>%1 bij %2 % grootte</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureMenu</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 en nog %n</numerusform>
            <numerusform>%1 en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Section &amp;Here</source>
        <translation>&amp;Doorsnede hier</translation>
    </message>
    <message>
        <source>Section Here, of &amp;This Alone</source>
        <translation>Doorsnede hier, &amp;alleen hiervan</translation>
    </message>
    <message>
        <source>Turn &amp;Around This Place</source>
        <translation>&amp;Om deze plek draaien</translation>
    </message>
    <message>
        <source>Select Here</source>
        <translation>Hier kiezen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PictureScreen</name>
    <message>
        <source>none, as the processor draws</source>
        <translation>geen, omdat de processor tekent</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PlanTree</name>
    <message>
        <source>What would be imported</source>
        <translation>Wat geïmporteerd zou worden</translation>
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
        <translation>Structuur</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Driehoeken</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>Grootte, mm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Assenstelsel</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Eenheid</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Gladmaken</translation>
    </message>
    <message>
        <source>Fewer triangles</source>
        <translation>Minder driehoeken</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PocketsPanel</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message numerus="yes">
        <source>%n residues at its wall: %1</source>
        <translation>
            <numerusform>%n residu aan de wand: %1</numerusform>
            <numerusform>%n residuen aan de wand: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Holte</translation>
    </message>
    <message>
        <source>Volume Å³</source>
        <translation>Volume Å³</translation>
    </message>
    <message>
        <source>Mouth Å²</source>
        <translation>Monding Å²</translation>
    </message>
    <message>
        <source>Burial</source>
        <translation>Ingeslotenheid</translation>
    </message>
    <message>
        <source>The room that the small probe can fill</source>
        <translation>De ruimte die de kleine bol kan vullen</translation>
    </message>
    <message>
        <source>The surface across which the pocket is open; 0: it is closed</source>
        <translation>Het oppervlak waarover de holte open is; 0: ze is gesloten</translation>
    </message>
    <message>
        <source>The share of directions in which atoms lie within 10 Å</source>
        <translation>Het aandeel van de richtingen waarin atomen binnen 10 Å liggen</translation>
    </message>
    <message>
        <source>Its number, and what lies in it</source>
        <translation>Het nummer en wat erin ligt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Pockets</source>
        <translation>Holten</translation>
    </message>
    <message>
        <source>Click a pocket to put it in focus, with what lies in it</source>
        <translation>Klik op een holte om die in focus te zetten, met wat erin ligt</translation>
    </message>
    <message>
        <source>Radius of the ball that goes into pockets; water has 1.4 Å</source>
        <translation>Straal van de bol die in holten gaat; water heeft 1,4 Å</translation>
    </message>
    <message>
        <source>Radius of the ball that stays out: with a larger one, shallower and wider pockets count</source>
        <translation>Straal van de bol die buiten blijft: met een grotere tellen ook ondiepere en wijdere holten</translation>
    </message>
    <message>
        <source> Å³</source>
        <translation> Å³</translation>
    </message>
    <message>
        <source>Smaller pockets are left out</source>
        <translation>Kleinere holten worden weggelaten</translation>
    </message>
    <message>
        <source>&amp;Probe radius</source>
        <translation>&amp;Bolstraal</translation>
    </message>
    <message>
        <source>&amp;Large probe</source>
        <translation>&amp;Grote bol</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>&amp;Kleinste</translation>
    </message>
    <message>
        <source> Å</source>
        <translation> Å</translation>
    </message>
    <message>
        <source>Looking for pockets …</source>
        <translation>Holten worden gezocht …</translation>
    </message>
    <message>
        <source>Open a protein from a PDB or mmCIF file to see its pockets here.</source>
        <translation>Open een eiwit uit een PDB- of mmCIF-bestand om hier de holten te zien.</translation>
    </message>
    <message>
        <source>Nothing was looked for. Change a radius to start.</source>
        <translation>Er is niet gezocht. Wijzig een straal om te beginnen.</translation>
    </message>
    <message numerus="yes">
        <source>%n pockets</source>
        <translation>
            <numerusform>%n holte</numerusform>
            <numerusform>%n holten</numerusform>
        </translation>
    </message>
    <message>
        <source>Pocket %1 in Focus</source>
        <translation>Holte %1 in focus</translation>
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
        <translation>Geen label hier benoemt iets om naar te vragen</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <comment>answers of a quiz</comment>
        <translation>%1 van %2 goed</translation>
    </message>
    <message>
        <source>%1 / %2   Point at: %3</source>
        <comment>number of the question, of so many, what to point at</comment>
        <translation>%1 / %2   Wijs aan: %3</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <comment>answer of a quiz</comment>
        <translation>Goed: %1</translation>
    </message>
    <message>
        <source>No, that is: %1. Outlined is: %2</source>
        <comment>answer of a quiz</comment>
        <translation>Nee, dat is: %1. Omlijnd is: %2</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PresenterWindow</name>
    <message>
        <source>Notes</source>
        <translation>Notities</translation>
    </message>
    <message>
        <source>The next view</source>
        <translation>Het volgende aanzicht</translation>
    </message>
    <message>
        <source>This is the last view</source>
        <translation>Dit is het laatste aanzicht</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Hierna: %1</translation>
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
        <translation>Focus</translation>
    </message>
    <message>
        <source>These in detail, everything else by what it is to them</source>
        <translation>Deze in detail, al het andere naar wat het voor ze is</translation>
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
        <source>Ghost</source>
        <translation>Schim</translation>
    </message>
    <message>
        <source>These as their outer edges alone</source>
        <translation>Deze alleen met hun buitenranden</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Verborgen</translation>
    </message>
    <message>
        <source>Hides these</source>
        <translation>Verbergt deze</translation>
    </message>
    <message>
        <source>My presets</source>
        <translation>Mijn voorinstellingen</translation>
    </message>
    <message>
        <source>Looks that you have named</source>
        <translation>Uiterlijk dat je een naam gegeven hebt</translation>
    </message>
    <message>
        <source>&amp;Save This Look…</source>
        <translation>Dit uiterlijk op&amp;slaan…</translation>
    </message>
    <message>
        <source>&amp;Manage…</source>
        <translation>&amp;Beheren…</translation>
    </message>
</context>
<context>
    <name>sline::widgets::PrintProofDialog</name>
    <message>
        <source>in grey</source>
        <translation>in grijs</translation>
    </message>
    <message>
        <source>with protanopia</source>
        <translation>met protanopie</translation>
    </message>
    <message>
        <source>with deuteranopia</source>
        <translation>met deuteranopie</translation>
    </message>
    <message>
        <source>with tritanopia</source>
        <translation>met tritanopie</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>op het scherm</translation>
    </message>
    <message>
        <source>Neighbours that look alike</source>
        <translation>Buren die op elkaar lijken</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Buren</translation>
    </message>
    <message>
        <source>Look alike</source>
        <translation>Lijken op elkaar</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Wat zou helpen</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nieuw</translation>
    </message>
    <message>
        <source>&amp;Also what looks alike on the screen</source>
        <translation>&amp;Ook wat op het scherm op elkaar lijkt</translation>
    </message>
    <message>
        <source>&amp;With the changes</source>
        <translation>&amp;Met de wijzigingen</translation>
    </message>
    <message>
        <source>Make the &amp;Changes</source>
        <translation>Wijzigingen &amp;doorvoeren</translation>
    </message>
    <message>
        <source>Print Proof</source>
        <translation>Drukproef</translation>
    </message>
    <message>
        <source>Which may be meant: both kidneys have one colour</source>
        <translation>Wat bedoeld kan zijn: beide nieren hebben één kleur</translation>
    </message>
    <message>
        <source>As it is seen</source>
        <translation>Zoals het gezien wordt</translation>
    </message>
    <message>
        <source>Seen %1</source>
        <translation>Gezien %1</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Voorbeeld</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Looking at the picture…</source>
        <translation>De afbeelding wordt bekeken…</translation>
    </message>
    <message>
        <source>All neighbours can be told apart in grey and by all eyes.</source>
        <translation>Alle buren zijn in grijs en voor alle ogen te onderscheiden.</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of neighbours look alike in print or to some eyes.</source>
        <translation>
            <numerusform>%n paar buren lijkt in druk of voor sommige ogen op elkaar.</numerusform>
            <numerusform>%n paren buren lijken in druk of voor sommige ogen op elkaar.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n of them no change was found.</source>
        <translation>
            <numerusform>Voor %n ervan is geen wijziging gevonden.</numerusform>
            <numerusform>Voor %n ervan is geen wijziging gevonden.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>kleur</translation>
    </message>
    <message>
        <source>Γ %1</source>
        <translation>Γ %1</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wordt getekend…</translation>
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
        <translation>Niet-opgeslagen werk herstellen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Later</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Het programma is niet goed geëindigd. Het had bewaard:</translation>
    </message>
</context>
<context>
    <name>sline::widgets::RecoveryList</name>
    <message>
        <source>A damaged copy</source>
        <translation>Een beschadigde kopie</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nooit opgeslagen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Delete the unsaved work on “%1”?</source>
        <translation>Niet-opgeslagen werk aan ‘%1’ verwijderen?</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Het kan niet worden teruggehaald.</translation>
    </message>
    <message>
        <source>%1, in an unknown folder</source>
        <translation>%1, in een onbekende map</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SavePresetDialog</name>
    <message>
        <source>Save Preset</source>
        <translation>Voorinstelling opslaan</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Naam</translation>
    </message>
    <message>
        <source>What it keeps of the look:</source>
        <translation>Wat die van het uiterlijk bewaart:</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Vervangen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ScaleBarMark</name>
    <message>
        <source>Scale: %1</source>
        <translation>Schaal: %1</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionActions</name>
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
    <message>
        <source>&amp;Sagittal</source>
        <translation>&amp;Sagittaal</translation>
    </message>
    <message>
        <source>&amp;Coronal</source>
        <translation>&amp;Coronaal</translation>
    </message>
    <message>
        <source>&amp;Axial</source>
        <translation>&amp;Axiaal</translation>
    </message>
    <message>
        <source>%1 cannot be added: a structure can have %2 sections at most</source>
        <translation>%1 kan niet worden toegevoegd: een structuur kan hoogstens %2 doorsneden hebben</translation>
    </message>
    <message>
        <source>Take another section away first</source>
        <translation>Haal eerst een andere doorsnede weg</translation>
    </message>
    <message>
        <source>Of %1 alone</source>
        <translation>Alleen van %1</translation>
    </message>
    <message>
        <source>Facing the &amp;View</source>
        <translation>&amp;Dwars op de blik</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionList</name>
    <message>
        <source>Section</source>
        <translation>Doorsnede</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Positie</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Snijdt</translation>
    </message>
    <message>
        <source>Rename Section</source>
        <translation>Doorsnede hernoemen</translation>
    </message>
    <message>
        <source>Section On</source>
        <translation>Doorsnede aan</translation>
    </message>
    <message>
        <source>Section Off</source>
        <translation>Doorsnede uit</translation>
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
        <translation>Doorsnede omkeren</translation>
    </message>
    <message>
        <source>Tilt Section</source>
        <translation>Doorsnede kantelen</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Doorsnede verschuiven</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SectionsPanel</name>
    <message>
        <source>Sections</source>
        <translation>Doorsneden</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Nieuw</translation>
    </message>
    <message>
        <source>Add a section plane</source>
        <translation>Een snijvlak toevoegen</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Omkeren</translation>
    </message>
    <message>
        <source>Keep the other side of this section</source>
        <translation>De andere kant van deze doorsnede houden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Take this section away</source>
        <translation>Deze doorsnede weghalen</translation>
    </message>
    <message>
        <source>Flip Section</source>
        <translation>Doorsnede omkeren</translation>
    </message>
    <message>
        <source>Towards the left, the back or the head; of an oblique section along its normal</source>
        <translation>Naar links, achteren of het hoofd; bij een schuine doorsnede langs de normaal</translation>
    </message>
    <message>
        <source>Hatched cut faces</source>
        <translation>Gearceerde snijvlakken</translation>
    </message>
    <message>
        <source>Move Section</source>
        <translation>Doorsnede verschuiven</translation>
    </message>
    <message>
        <source>Hatched Cut Faces</source>
        <translation>Gearceerde snijvlakken</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Positie</translation>
    </message>
    <message>
        <source>&amp;Cuts</source>
        <translation>Sn&amp;ijdt</translation>
    </message>
    <message>
        <source>Delete Section</source>
        <translation>Doorsnede verwijderen</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Gekozen: %1</translation>
    </message>
    <message>
        <source>What a Section Cuts</source>
        <translation>Wat een doorsnede snijdt</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tint</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Weefsel</translation>
    </message>
    <message>
        <source>Cut faces as white as the paper, in a tint of the structure&apos;s colour, or with the pattern of its tissue as in printed atlases</source>
        <translation>Snijvlakken zo wit als het papier, in een tint van de kleur van de structuur, of met het patroon van het weefsel zoals in gedrukte atlassen</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Snijvlakken</translation>
    </message>
    <message>
        <source>Cut Faces</source>
        <translation>Snijvlakken</translation>
    </message>
    <message>
        <source>Along the X, the Y or the Z axis; of an oblique section along its normal</source>
        <translation>Langs de X-, de Y- of de Z-as; bij een schuine doorsnede langs haar normaal</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SelectionPanel</name>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importeren</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>&amp;Kleur…</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Assenstelsel</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Eenheid</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Gladmaken</translation>
    </message>
    <message>
        <source>Fewer &amp;triangles</source>
        <translation>Minder &amp;driehoeken</translation>
    </message>
    <message>
        <source>As for all</source>
        <translation>Zoals voor alle</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Verschillend</translation>
    </message>
    <message numerus="yes">
        <source>For the selected %n structures</source>
        <translation>
            <numerusform>Voor de gekozen structuur</numerusform>
            <numerusform>Voor de gekozen %n structuren</numerusform>
        </translation>
    </message>
    <message>
        <source>Select structures to treat them unlike the others</source>
        <translation>Kies structuren om ze anders te behandelen dan de rest</translation>
    </message>
    <message>
        <source>For “%1”</source>
        <translation>Voor ‘%1’</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Session</name>
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
    <message>
        <source>Close %1</source>
        <translation>%1 sluiten</translation>
    </message>
    <message>
        <source>Revert to Saved</source>
        <translation>Terug naar opgeslagen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Vergrendelen</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Ontgrendelen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 van %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n items</source>
        <translation>
            <numerusform>%1 van %n onderdeel</numerusform>
            <numerusform>%1 van %n onderdelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>One of them has reached the end, and all keep their differences. A drag with Shift makes them equal.</source>
        <translation>Eén is aan het einde gekomen, en alle houden hun verschillen. Slepen met Shift maakt ze gelijk.</translation>
    </message>
    <message>
        <source>Structures that differ keep their differences; with Shift all become equal</source>
        <translation>Structuren die verschillen houden hun verschillen; met Shift worden ze allemaal gelijk</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Naamloos</translation>
    </message>
    <message>
        <source>Nobody has said how long the unit of its files is, and not all has the size that it should have: lengths stand with a “?”</source>
        <translation>Niemand heeft gezegd hoe lang de eenheid van de bestanden is, en niet alles heeft de grootte die het zou moeten hebben: lengtes staan met een “?”</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SidesActions</name>
    <message>
        <source>Left and right</source>
        <translation>Links en rechts</translation>
    </message>
    <message>
        <source>Sides are right</source>
        <translation>Zijden kloppen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegelen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Later vragen</translation>
    </message>
    <message>
        <source>Ask later: the menu Edit has the same answers</source>
        <translation>Later vragen: het menu Bewerken heeft dezelfde antwoorden</translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation>Links en rechts spiegelen</translation>
    </message>
    <message>
        <source>Turn about the body&apos;s axis</source>
        <translation>Om de lichaamsas draaien</translation>
    </message>
    <message>
        <source>Left and right are not certain: names or places contradict the frame.</source>
        <translation>Links en rechts zijn niet zeker: namen of plaatsen spreken het assenstelsel tegen.</translation>
    </message>
    <message>
        <source>Left and right are not certain: they were assumed.</source>
        <translation>Links en rechts zijn niet zeker: ze zijn aangenomen.</translation>
    </message>
    <message>
        <source>Read as %1 (%2).</source>
        <translation>Gelezen als %1 (%2).</translation>
    </message>
    <message>
        <source>Front and back are not certain: names tell left and right alone.</source>
        <translation>Voor en achter zijn niet zeker: namen noemen alleen links en rechts.</translation>
    </message>
    <message>
        <source>Names are right</source>
        <translation>Namen kloppen</translation>
    </message>
    <message>
        <source>Labels show such names with a question mark, and no question asks for them.</source>
        <translation>Labels tonen zulke namen met een vraagteken, en geen vraag vraagt ernaar.</translation>
    </message>
    <message>
        <source>Nothing tells that z leads to the head; it was assumed.</source>
        <translation>Niets zegt dat z naar het hoofd wijst; het werd aangenomen.</translation>
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
        <translation>Laatst geopend</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Demos, Modelled by the Program</source>
        <translation>Demo’s, door het programma gemodelleerd</translation>
    </message>
    <message>
        <source>Sline</source>
        <translation>Sline</translation>
    </message>
    <message>
        <source>Focus-and-context line drawings of anatomy</source>
        <translation>Lijntekeningen van anatomie met focus en context</translation>
    </message>
    <message>
        <source>Open Files…</source>
        <translation>Bestanden openen…</translation>
    </message>
    <message>
        <source>Open Folder…</source>
        <translation>Map openen…</translation>
    </message>
    <message>
        <source>or drop files and folders into this window</source>
        <translation>of sleep bestanden en mappen naar dit venster</translation>
    </message>
    <message>
        <source>The program did not end as it should. It had kept:</source>
        <translation>Het programma is niet goed geëindigd. Het had bewaard:</translation>
    </message>
    <message>
        <source>no longer there</source>
        <translation>niet meer aanwezig</translation>
    </message>
    <message>
        <source>Drawing Style for What Is Opened Next</source>
        <translation>Tekenstijl voor wat hierna wordt geopend</translation>
    </message>
    <message>
        <source>Demos and scene files keep their own</source>
        <translation>Demo’s en scènebestanden houden die van henzelf</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureActions</name>
    <message>
        <source>Context</source>
        <translation>Context</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureDelegate</name>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureProperties</name>
    <message>
        <source>Properties</source>
        <translation>Eigenschappen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiëren</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Getekend</translation>
    </message>
    <message>
        <source>Authors</source>
        <translation>Auteurs</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Bron</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licentie</translation>
    </message>
    <message>
        <source>Whose work the surface is; exports print it where you wish</source>
        <translation>Wiens werk het oppervlak is; exports drukken het af waar je dat wenst</translation>
    </message>
    <message>
        <source>several</source>
        <translation>meerdere</translation>
    </message>
    <message>
        <source>Say Whose Work It Is</source>
        <translation>Zeggen wiens werk het is</translation>
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
    <message>
        <source>No structure is called so</source>
        <translation>Geen structuur heet zo</translation>
    </message>
    <message numerus="yes">
        <source>%n structures – Enter selects them</source>
        <translation>
            <numerusform>%n structuur – Enter kiest hem</numerusform>
            <numerusform>%n structuren – Enter kiest ze</numerusform>
        </translation>
    </message>
    <message>
        <source>Words in any order; “%1” or a comma between them finds either. Enter selects all that match, Down goes to the list, Escape shows all again.</source>
        <translation>Woorden in willekeurige volgorde; “%1” of een komma ertussen vindt het ene en het andere. Enter kiest alles wat past, Omlaag gaat naar de lijst, Esc toont alles weer.</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeModel</name>
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
    <message>
        <source>%1, its own</source>
        <translation>%1, eigen</translation>
    </message>
    <message>
        <source>Colour, its own</source>
        <translation>Kleur, eigen</translation>
    </message>
    <message>
        <source>Colours of what is in it</source>
        <translation>Kleuren van wat erin zit</translation>
    </message>
    <message>
        <source>Colour, from the group above</source>
        <translation>Kleur, van de groep erboven</translation>
    </message>
    <message>
        <source>opacity %1 %, its own</source>
        <translation>dekking %1 %, eigen</translation>
    </message>
    <message>
        <source>opacity %1 %</source>
        <translation>dekking %1 %</translation>
    </message>
    <message>
        <source>Not locked</source>
        <translation>Niet vergrendeld</translation>
    </message>
    <message>
        <source>Locked by the group above: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Vergrendeld door de groep erboven: houdt uiterlijk, naam en plaats en kan in het beeld niet aangeklikt worden</translation>
    </message>
    <message>
        <source>Locked: keeps its look, name and place and cannot be clicked in the picture</source>
        <translation>Vergrendeld: houdt uiterlijk, naam en plaats en kan in het beeld niet aangeklikt worden</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 tot %2</translation>
    </message>
    <message>
        <source>%1: lies on the other side than its name says</source>
        <translation>%1: ligt aan de andere kant dan de naam zegt</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StructureTreeView</name>
    <message>
        <source>Structures</source>
        <translation>Structuren</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vergrendeld</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleActions</name>
    <message>
        <source>Paste Style</source>
        <translation>Stijl plakken</translation>
    </message>
    <message>
        <source>Paste Style, Keep Colour</source>
        <translation>Stijl plakken, kleur behouden</translation>
    </message>
    <message>
        <source>Make Like</source>
        <translation>Maken zoals</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleChoiceEditor</name>
    <message>
        <source>Several</source>
        <translation>Verschillende</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleColourEditor</name>
    <message>
        <source>Several</source>
        <translation>Meerdere</translation>
    </message>
    <message>
        <source>With the background</source>
        <translation>Met de achtergrond</translation>
    </message>
</context>
<context>
    <name>sline::widgets::StyleEditor</name>
    <message>
        <source>Reset</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>As the group above, or the usual, says</source>
        <translation>Zoals de groep erboven of het gewone zegt</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 herstellen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::SubjectPopup</name>
    <message>
        <source>Working out other plates…</source>
        <translation>Andere platen worden uitgewerkt…</translation>
    </message>
    <message>
        <source>Other subjects</source>
        <translation>Andere onderwerpen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdEditor</name>
    <message>
        <source>Thresholds of lines</source>
        <translation>Drempels van lijnen</translation>
    </message>
    <message>
        <source>How strong lines must be for their technique to draw them</source>
        <translation>Hoe sterk lijnen moeten zijn om door hun techniek te worden getekend</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ThresholdPanel</name>
    <message>
        <source>Bone</source>
        <translation>Bot</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Huid</translation>
    </message>
    <message>
        <source>Contrast vessels</source>
        <translation>Vaten met contrast</translation>
    </message>
    <message>
        <source>&amp;Keep the scan with the scene (for slices)</source>
        <translation>De scan bij de scène be&amp;waren (voor doorsneden)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Axial, coronal and sagittal slice through the middle</source>
        <translation>Axiale, coronale en sagittale doorsnede door het midden</translation>
    </message>
    <message>
        <source>Name of the structure</source>
        <translation>Naam van de structuur</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Naam</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Van</translation>
    </message>
    <message>
        <source>t&amp;o</source>
        <translation>t&amp;ot</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HU</translation>
    </message>
    <message>
        <source>No structure is made of the scan yet</source>
        <translation>Van de scan is nog geen structuur gemaakt</translation>
    </message>
    <message>
        <source>Made of scans: %1</source>
        <translation>Van scans gemaakt: %1</translation>
    </message>
    <message>
        <source>&amp;Add structure</source>
        <translation>Structuur &amp;toevoegen</translation>
    </message>
    <message>
        <source>&amp;Add another structure</source>
        <translation>Nog een structuur &amp;toevoegen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::TourActions</name>
    <message>
        <source>Views</source>
        <translation>Aanzichten</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewActions</name>
    <message>
        <source>Key Light</source>
        <translation>Hoofdlicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewCard</name>
    <message>
        <source>Name of the view</source>
        <translation>Naam van het aanzicht</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewList</name>
    <message numerus="yes">
        <source>%n of the structures and labels it shows are no longer in the scene</source>
        <translation>
            <numerusform>%n van de structuren en labels die het toont, is niet meer in de scène</numerusform>
            <numerusform>%n van de structuren en labels die het toont, zijn niet meer in de scène</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewRow</name>
    <message>
        <source>Saved views</source>
        <translation>Opgeslagen aanzichten</translation>
    </message>
    <message>
        <source>A view keeps what you see: camera, what is shown, Γ, colours and sections</source>
        <translation>Een aanzicht bewaart wat u ziet: camera, wat wordt getoond, Γ, kleuren en doorsneden</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewTour</name>
    <message>
        <source>View “%1”</source>
        <translation>Aanzicht ‘%1’</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Aanzicht %1</translation>
    </message>
    <message>
        <source>Add View</source>
        <translation>Aanzicht toevoegen</translation>
    </message>
    <message>
        <source>Update View “%1”</source>
        <translation>Aanzicht “%1” bijwerken</translation>
    </message>
    <message>
        <source>Delete View “%1”</source>
        <translation>Aanzicht “%1” verwijderen</translation>
    </message>
    <message>
        <source>Rename View</source>
        <translation>Aanzicht hernoemen</translation>
    </message>
    <message>
        <source>Move View</source>
        <translation>Aanzicht verplaatsen</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewWordsEditor</name>
    <message>
        <source>What is to be read with the view</source>
        <translation>Wat bij het aanzicht te lezen is</translation>
    </message>
    <message>
        <source>Notes for who presents the view</source>
        <translation>Notities voor wie het aanzicht vertoont</translation>
    </message>
    <message>
        <source>For you alone, while you present: no file for others has them</source>
        <translation>Alleen voor jou, terwijl je vertoont: geen bestand voor anderen heeft ze</translation>
    </message>
    <message>
        <source>Title of the view</source>
        <translation>Titel van het aanzicht</translation>
    </message>
    <message>
        <source>What the view is called where it is shown, if that is not its name</source>
        <translation>Hoe het aanzicht heet waar het getoond wordt, als dat niet zijn naam is</translation>
    </message>
    <message>
        <source>How long the view is shown</source>
        <translation>Hoe lang het aanzicht getoond wordt</translation>
    </message>
    <message>
        <source>How long a film rests at the view; 0 for as long as at the others</source>
        <translation>Hoe lang een film bij het aanzicht rust; 0 voor even lang als bij de andere</translation>
    </message>
    <message>
        <source> s</source>
        <comment>seconds</comment>
        <translation> s</translation>
    </message>
    <message>
        <source>as others</source>
        <comment>how long a view is shown</comment>
        <translation>als andere</translation>
    </message>
    <message>
        <source>Change What a View Says</source>
        <translation>Wijzigen wat een aanzicht zegt</translation>
    </message>
    <message>
        <source>Choose a view</source>
        <translation>Kies een aanzicht</translation>
    </message>
    <message>
        <source>Text, to be read with the view</source>
        <translation>Tekst, bij het aanzicht te lezen</translation>
    </message>
    <message>
        <source>Notes, for who presents it</source>
        <translation>Notities, voor wie het vertoont</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Wat het aanzicht toont</translation>
    </message>
    <message>
        <source>For who does not see the picture: files for others have it, and without it they say what is seen</source>
        <translation>Voor wie de afbeelding niet ziet: bestanden voor anderen hebben het, en zonder dit zeggen ze wat er te zien is</translation>
    </message>
    <message>
        <source>Description, for who does not see it</source>
        <translation>Beschrijving, voor wie het niet ziet</translation>
    </message>
</context>
<context>
    <name>sline::widgets::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Beeld</translation>
    </message>
</context>
<context>
    <name>sline::widgets::ViewsPanel</name>
    <message>
        <source>Update View</source>
        <translation>Aanzicht bijwerken</translation>
    </message>
    <message>
        <source>The chosen view shows from now on what is seen now</source>
        <translation>Het gekozen aanzicht toont voortaan wat nu te zien is</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Take the chosen view away</source>
        <translation>Het gekozen aanzicht weghalen</translation>
    </message>
    <message>
        <source>Text, Notes</source>
        <translation>Tekst, notities</translation>
    </message>
    <message>
        <source>Show what the chosen view says, to be typed below</source>
        <translation>Tonen wat het gekozen aanzicht zegt, om het eronder te typen</translation>
    </message>
</context>
</TS>
