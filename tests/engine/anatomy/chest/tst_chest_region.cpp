#include "engine/anatomy/chest/chest_region.h"
#include "tests/support/test_class.h"

namespace carina::chest_region_test
{

class TestChestRegion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsHowEachRoleMoves_data();
    void tellsHowEachRoleMoves();
    void movesSomePartsOtherwiseThanTheirRole_data();
    void movesSomePartsOtherwiseThanTheirRole();
    void fixesLowerTeethGumAndLipToTheMandible();
    void putsLungsAndNothingElseIntoLungs();
    void tellsWhichTissueABladeAndEventsMove();
};

void TestChestRegion::tellsHowEachRoleMoves_data()
{
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<ChestRegion>("region");
    QTest::newRow("right upper lobe") << PartRole::RightUpperLobe << ChestRegion::RightUpperLung;
    QTest::newRow("right middle lobe") << PartRole::RightMiddleLobe << ChestRegion::RightUpperLung;
    QTest::newRow("right lower lobe") << PartRole::RightLowerLobe << ChestRegion::RightLowerLung;
    QTest::newRow("right lung") << PartRole::RightLung << ChestRegion::RightUpperLung;
    QTest::newRow("left upper lobe") << PartRole::LeftUpperLobe << ChestRegion::LeftUpperLung;
    QTest::newRow("left lower lobe") << PartRole::LeftLowerLobe << ChestRegion::LeftLowerLung;
    QTest::newRow("left lung") << PartRole::LeftLung << ChestRegion::LeftUpperLung;
    QTest::newRow("right main bronchus") << PartRole::RightMainBronchus << ChestRegion::Bronchi;
    QTest::newRow("left main bronchus") << PartRole::LeftMainBronchus << ChestRegion::Bronchi;
    QTest::newRow("bronchial tree") << PartRole::BronchialTree << ChestRegion::Bronchi;
    QTest::newRow("diaphragm") << PartRole::Diaphragm << ChestRegion::Diaphragm;
    QTest::newRow("rib") << PartRole::Rib << ChestRegion::Wall;
    QTest::newRow("skin") << PartRole::Skin << ChestRegion::Skin;
    QTest::newRow("tooth") << PartRole::Tooth << ChestRegion::Teeth;
    QTest::newRow("trachea") << PartRole::Trachea << ChestRegion::Mediastinum;
    QTest::newRow("oesophagus") << PartRole::Oesophagus << ChestRegion::Mediastinum;
    QTest::newRow("heart") << PartRole::Heart << ChestRegion::Mediastinum;
    QTest::newRow("vessel") << PartRole::Vessel << ChestRegion::Mediastinum;
    for (const PartRole throat :
         {PartRole::Tongue, PartRole::Hyoid, PartRole::Mucosa, PartRole::Muscle})
        QTest::newRow(roleName(throat)) << throat << ChestRegion::Throat;
    for (const PartRole larynx :
         {PartRole::Larynx, PartRole::Epiglottis, PartRole::LaryngealMucosa, PartRole::VocalFold})
        QTest::newRow(roleName(larynx)) << larynx << ChestRegion::Larynx;
    QTest::newRow("pharynx") << PartRole::Pharynx << ChestRegion::Pharynx;
    for (const PartRole still :
         {PartRole::Mandible, PartRole::Skull, PartRole::Spine, PartRole::Other})
        QTest::newRow(roleName(still)) << still << ChestRegion::Still;
}

void TestChestRegion::tellsHowEachRoleMoves()
{
    QFETCH(PartRole, role);
    QFETCH(ChestRegion, region);
    QCOMPARE(regionOf(role), region);
}

void TestChestRegion::movesSomePartsOtherwiseThanTheirRole_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<ChestRegion>("region");
    const auto row = [](const char* name, PartRole role, ChestRegion region) {
        QTest::newRow(name) << QString::fromLatin1(name) << role << region;
    };
    for (const char* name :
         {"Left palatoglossal arch", "Right palatopharyngeal arch", "Palatine tonsil"})
        row(name, PartRole::Mucosa, ChestRegion::Pharynx);
    for (const char* name : {"Gingiva of upper jaw", "Upper lip", "UPPER LIP"})
        row(name, PartRole::Mucosa, ChestRegion::Skin);
    for (const char* name :
         {"Buccal mucosa", "Median glosso-epiglottic fold", "Lower lip", "Gingiva of lower jaw"})
        row(name, PartRole::Mucosa, ChestRegion::Throat);
    row("Maxilla of upper jaw", PartRole::Skull, ChestRegion::Still);
    row("Palatoglossus", PartRole::Muscle, ChestRegion::Throat);
    row("Hyoid bone", PartRole::Hyoid, ChestRegion::Throat);
    row("Thyrohyoid membrane", PartRole::Larynx, ChestRegion::Larynx);
    row("Left lateral thyrohyoid ligament", PartRole::Larynx, ChestRegion::Larynx);
    row("Suprahyoid branch of lingual artery", PartRole::Vessel, ChestRegion::Mediastinum);
    row("Mylohyoid nerve", PartRole::Other, ChestRegion::Still);
    row("Left vocal fold", PartRole::VocalFold, ChestRegion::Larynx);
    row("Right upper central secondary incisor tooth", PartRole::Tooth, ChestRegion::LooseTooth);
    row("Right upper central primary incisor tooth", PartRole::Tooth, ChestRegion::LooseTooth);
    row("Left upper central secondary incisor tooth", PartRole::Tooth, ChestRegion::Teeth);
    row("Right lower central secondary incisor tooth", PartRole::Tooth, ChestRegion::Teeth);
}

void TestChestRegion::movesSomePartsOtherwiseThanTheirRole()
{
    QFETCH(const QString, name);
    QFETCH(const PartRole, role);
    QFETCH(const ChestRegion, region);
    QCOMPARE(regionOf(AnatomyPart{
                 .name = name.toStdString(), .role = role, .conceptId = {}, .levels = {}}),
             region);
}

// In capitals or not, as upper ones are found.
void TestChestRegion::fixesLowerTeethGumAndLipToTheMandible()
{
    const auto moves = [](const char* name, PartRole role) {
        return movesWithMandible({.name = name, .role = role, .conceptId = {}, .levels = {}});
    };
    QVERIFY(moves("Mandible", PartRole::Mandible));
    QVERIFY(moves("Left lower first molar", PartRole::Tooth));
    for (const char* name : {"Gingiva of lower jaw", "Lower lip", "LOWER LIP"})
        QVERIFY2(moves(name, PartRole::Mucosa), name);
    QVERIFY(!moves("Left upper first molar", PartRole::Tooth));
    for (const char* name : {"Gingiva of upper jaw", "Upper lip", "Buccal mucosa"})
        QVERIFY2(!moves(name, PartRole::Mucosa), name);
    QVERIFY(!moves("Artery of lower lip", PartRole::Vessel));
}

void TestChestRegion::putsLungsAndNothingElseIntoLungs()
{
    for (int n = 0; n <= static_cast<int>(PartRole::Other); ++n) {
        const auto role = static_cast<PartRole>(n);
        const ChestRegion region = regionOf(role);
        const bool right =
            region == ChestRegion::RightUpperLung || region == ChestRegion::RightLowerLung;
        const bool left =
            region == ChestRegion::LeftUpperLung || region == ChestRegion::LeftLowerLung;
        QCOMPARE(lungSide(role) == Side::Right, right);
        QCOMPARE(lungSide(role) == Side::Left, left);
        QVERIFY(static_cast<std::size_t>(region) < kChestRegions);
    }
}

// What gives way to a blade follows the jaw, too.
void TestChestRegion::tellsWhichTissueABladeAndEventsMove()
{
    QVERIFY(airwayTissueOf(regionOf(PartRole::Tongue)) == AirwayTissue::Throat);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Epiglottis)) == AirwayTissue::Larynx);
    QVERIFY(airwayTissueOf(regionOf(PartRole::VocalFold)) == AirwayTissue::Larynx);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Pharynx)) == AirwayTissue::Pharynx);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Tooth)) == AirwayTissue::Teeth);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Skin)) == AirwayTissue::Skin);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Trachea)) == AirwayTissue::Windpipe);
    QVERIFY(airwayTissueOf(regionOf(PartRole::Oesophagus)) == AirwayTissue::Windpipe);
    for (const PartRole still : {PartRole::Mandible, PartRole::Skull, PartRole::Spine,
                                 PartRole::Rib, PartRole::LeftMainBronchus})
        QVERIFY(!airwayTissueOf(regionOf(still)));
    for (std::size_t n = 0; n < kChestRegions; ++n) {
        const auto region = static_cast<ChestRegion>(n);
        const auto tissue = airwayTissueOf(region);
        const bool givesWay = tissue && (kThroatTissues & only(*tissue)) != 0;
        QVERIFY(!givesWay || tissueOf(region));
    }
}

CARINA_TEST(TestChestRegion)

} // namespace carina::chest_region_test

#include "tst_chest_region.moc"
