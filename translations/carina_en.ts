<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>RegistrationWords</name>
    <message numerus="yes">
        <source>Slide the tip back and forth over this surface, then refine: %n points so far.</source>
        <translation>
            <numerusform>Slide the tip back and forth over this surface, then refine: %n point so far.</numerusform>
            <numerusform>Slide the tip back and forth over this surface, then refine: %n points so far.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::FitPage</name>
    <message numerus="yes">
        <source>%n points, %1 are the fewest.</source>
        <translation>
            <numerusform>%n point, %1 are the fewest.</numerusform>
            <numerusform>%n points, %1 are the fewest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::ImportDialog</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::NetworkPanel</name>
    <message numerus="yes">
        <source>%n delays, mean %1 ms, sigma %2 ms</source>
        <translation>
            <numerusform>%n delay, mean %1 ms, sigma %2 ms</numerusform>
            <numerusform>%n delays, mean %1 ms, sigma %2 ms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::AttentionBar</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::Readiness</name>
    <message numerus="yes">
        <source>%n days ago</source>
        <translation>
            <numerusform>%n day ago</numerusform>
            <numerusform>%n days ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::SessionSummary</name>
    <message numerus="yes">
        <source>%n decisions and events, in %1</source>
        <translation>
            <numerusform>%n decision or event, in %1</numerusform>
            <numerusform>%n decisions and events, in %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>carina::StoredSessionsModel</name>
    <message numerus="yes">
        <source>%n minutes</source>
        <translation>
            <numerusform>%n minute</numerusform>
            <numerusform>%n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Try</name>
    <message numerus="yes">
        <source>%1 of %2 points</source>
        <translation>
            <numerusform>%1 of %2 point</numerusform>
            <numerusform>%1 of %2 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1 of %2 points</source>
        <translation>
            <numerusform>✓ %1 of %2 point</numerusform>
            <numerusform>✓ %1 of %2 points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>▲ %1 points: %2</source>
        <translation>
            <numerusform>▲ %1 point: %2</numerusform>
            <numerusform>▲ %1 points: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>▲ %1 of %2 points: %3</source>
        <translation>
            <numerusform>▲ %1 of %2 point: %3</numerusform>
            <numerusform>▲ %1 of %2 points: %3</numerusform>
        </translation>
    </message>
</context>
</TS>
