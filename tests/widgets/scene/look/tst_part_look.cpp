#include "tests/support/test_class.h"
#include "widgets/scene/look/part_look.h"

namespace carina::part_look_test
{

namespace
{

ScenePart part(std::uint16_t id, MaterialGroup group)
{
    ScenePart made;
    made.id = id;
    made.group = group;
    made.color = QColor(10, 20, 30);
    return made;
}

} // namespace

class TestPartLook : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsAsUsualWhatIsNotSpokenOf();
    void drawsAPartAsWanted_data();
    void drawsAPartAsWanted();
    void leavesOutWhatIsHidden();
    void showsWhatIsHighlightedEvenWhereHidden();
    void keepsTheColoursAPartCameWithUntilOneColourIsWanted();
};

void TestPartLook::showsAsUsualWhatIsNotSpokenOf()
{
    const std::vector parts{part(1, MaterialGroup::Lung), part(2, MaterialGroup::Bone)};
    const PartLooks looks{{7, {PartStyle::Hidden}}, {2, {.labelled = true}}};
    const std::vector<ScenePart> shown = withLooks(parts, looks);
    QCOMPARE(shown.size(), std::size_t{2});
    QCOMPARE(shown[0].group, MaterialGroup::Lung);
    QCOMPARE(shown[1].group, MaterialGroup::Bone);
    QCOMPARE(shown[1].color, QColor(10, 20, 30));
}

void TestPartLook::drawsAPartAsWanted_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::addColumn<PartStyle>("style");
    QTest::addColumn<bool>("highlighted");
    QTest::addColumn<MaterialGroup>("drawn");
    const auto row = [](const char* name, MaterialGroup group, PartStyle style, bool highlighted,
                        MaterialGroup drawn) {
        QTest::newRow(name) << group << style << highlighted << drawn;
    };
    using enum MaterialGroup;
    row("solid lung", Lung, PartStyle::Solid, false, SoftTissue);
    row("solid bone", Bone, PartStyle::Solid, false, Bone);
    row("solid tool", Tool, PartStyle::Solid, false, Tool);
    row("ghost of a bone", Bone, PartStyle::Ghost, false, Ghost);
    row("ghost of a lung", Lung, PartStyle::Ghost, false, Ghost);
    row("highlighted lung", Lung, PartStyle::AsUsual, true, SoftTissue);
    row("highlighted ghost", Skin, PartStyle::Ghost, true, SoftTissue);
    row("highlighted bone", Bone, PartStyle::Ghost, true, Bone);
}

void TestPartLook::drawsAPartAsWanted()
{
    QFETCH(MaterialGroup, group);
    QFETCH(PartStyle, style);
    QFETCH(bool, highlighted);
    const std::vector<ScenePart> shown =
        withLooks(std::vector{part(5, group)}, {{5, {style, highlighted}}});
    QCOMPARE(shown.size(), std::size_t{1});
    QTEST(shown[0].group, "drawn");
    QCOMPARE(shown[0].color, highlighted ? kHighlight : QColor(10, 20, 30));
}

void TestPartLook::leavesOutWhatIsHidden()
{
    const std::vector parts{part(1, MaterialGroup::Lung), part(2, MaterialGroup::Bone)};
    const std::vector<ScenePart> shown = withLooks(parts, {{1, {PartStyle::Hidden}}});
    QCOMPARE(shown.size(), std::size_t{1});
    QCOMPARE(shown[0].id, std::uint16_t{2});
}

void TestPartLook::showsWhatIsHighlightedEvenWhereHidden()
{
    const std::vector<ScenePart> shown =
        withLooks(std::vector{part(1, MaterialGroup::Lung)}, {{1, {PartStyle::Hidden, true}}});
    QCOMPARE(shown.size(), std::size_t{1});
    QCOMPARE(shown[0].group, MaterialGroup::SoftTissue);
}

void TestPartLook::keepsTheColoursAPartCameWithUntilOneColourIsWanted()
{
    ScenePart skin = part(1, MaterialGroup::Skin);
    skin.colors = {{{1, 2, 3}}};
    const auto shown = [&](const PartLook& look) {
        return withLooks(std::vector{skin}, {{1, look}}).front();
    };
    QVERIFY(shown({}).colors == skin.colors);
    QVERIFY(shown({PartStyle::Solid}).colors == skin.colors);
    QVERIFY(shown({.plain = true}).colors.empty());
    QCOMPARE(shown({.plain = true}).color, QColor(10, 20, 30));
    QVERIFY(shown({.highlighted = true}).colors.empty());
    QCOMPARE(shown({.highlighted = true}).color, kHighlight);
}

CARINA_TEST(TestPartLook)

} // namespace carina::part_look_test

#include "tst_part_look.moc"
