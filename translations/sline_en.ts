<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
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
    <name>sline::widgets::Session</name>
    <message numerus="yes">
        <source>Γ of %n items</source>
        <translation>
            <numerusform>Γ of %n item</numerusform>
            <numerusform>Γ of %n items</numerusform>
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
        <source>%n structures were read again</source>
        <translation>
            <numerusform>%n structure was read again</numerusform>
            <numerusform>%n structures were read again</numerusform>
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
</TS>
