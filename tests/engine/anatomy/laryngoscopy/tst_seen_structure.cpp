#include "engine/anatomy/laryngoscopy/seen_structure.h"
#include "tests/support/test_class.h"

#include <set>
#include <string>

namespace carina::seen_structure_test
{

class TestSeenStructure : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recognisesPartsByRoleAndName_data();
    void recognisesPartsByRoleAndName();
    void hasANameOfItsOwnForEach();
};

void TestSeenStructure::recognisesPartsByRoleAndName_data()
{
    QTest::addColumn<PartRole>("role");
    QTest::addColumn<QString>("name");
    QTest::addColumn<SeenStructure>("structure");
    const auto row = [](const char* name, PartRole role, SeenStructure structure) {
        QTest::newRow(name) << role << QString::fromLatin1(name) << structure;
    };
    row("Left upper central secondary incisor tooth", PartRole::Tooth, SeenStructure::Teeth);
    row("Tongue", PartRole::Tongue, SeenStructure::Tongue);
    row("Hard palate", PartRole::Pharynx, SeenStructure::HardPalate);
    row("Soft palate", PartRole::Pharynx, SeenStructure::SoftPalate);
    row("Uvula", PartRole::Pharynx, SeenStructure::SoftPalate);
    row("Superior pharyngeal constrictor", PartRole::Pharynx, SeenStructure::Pharynx);
    row("Oral cavity", PartRole::Pharynx, SeenStructure::Nothing);
    row("Epiglottis", PartRole::Epiglottis, SeenStructure::Epiglottis);
    row("Left arytenoid cartilage", PartRole::Larynx, SeenStructure::Arytenoid);
    row("Right vocal ligament", PartRole::Larynx, SeenStructure::VocalFold);
    row("Left vestibular fold", PartRole::Larynx, SeenStructure::VestibularFold);
    row("Right aryepiglottic fold", PartRole::Larynx, SeenStructure::AryepiglotticFold);
    row("Thyroid cartilage", PartRole::Larynx, SeenStructure::LaryngealCartilage);
    row("Vallecula", PartRole::LaryngealMucosa, SeenStructure::Pharynx);
    row("Hyoid bone", PartRole::Hyoid, SeenStructure::LaryngealCartilage);
    row("Trachea", PartRole::Trachea, SeenStructure::Trachea);
    row("Oesophagus", PartRole::Oesophagus, SeenStructure::Oesophagus);
    row("Left second rib", PartRole::Rib, SeenStructure::Nothing);
    row("Skin", PartRole::Skin, SeenStructure::Nothing);
}

void TestSeenStructure::recognisesPartsByRoleAndName()
{
    QFETCH(const PartRole, role);
    QFETCH(const QString, name);
    QFETCH(const SeenStructure, structure);
    QCOMPARE(structureOf({.name = name.toStdString(), .role = role, .conceptId = {}, .levels = {}}),
             structure);
}

void TestSeenStructure::hasANameOfItsOwnForEach()
{
    std::set<std::string> names;
    for (std::size_t n = 0; n < kSeenStructures; ++n)
        names.insert(structureName(static_cast<SeenStructure>(n)));
    QCOMPARE(names.size(), kSeenStructures);
}

CARINA_TEST(TestSeenStructure)

} // namespace carina::seen_structure_test

#include "tst_seen_structure.moc"
