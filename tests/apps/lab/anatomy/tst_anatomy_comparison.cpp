#include "apps/lab/anatomy/comparison_report.h"
#include "evaluation/anatomy/anatomy_comparison.h"
#include "evaluation/anatomy/organ_groups.h"
#include "tests/evaluation/anatomy/known_airway.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::lab::anatomy_comparison_test
{

class TestAnatomyComparison final : public QObject
{
    Q_OBJECT

    static const Deviation& figure(const AnatomyComparison& c, const char* name)
    {
        return *std::ranges::find(c.figures, name, &Deviation::name);
    }

    static AnatomyComparison against(const test::KnownAirway& real, double size = 1.0)
    {
        return compareAnatomy(test::anatomyOf({}), test::anatomyOf(real, size)).value();
    }

    static AnatomyPart named(const char* name, PartRole role)
    {
        return {name, role, {}, {test::boxOf(Vec3::Zero(), Vec3::Ones())}};
    }

    static std::string organOf(const char* name, PartRole role)
    {
        Anatomy anatomy;
        anatomy.parts = {named(name, role)};
        const auto organs = organsOf(anatomy);
        return organs.empty() ? "" : organs.begin()->first;
    }

private Q_SLOTS:
    void findsNothingBetweenAPatientAndItselfAtAnotherSize()
    {
        const AnatomyComparison same = against({}, 1.25);
        QVERIFY(std::abs(same.airwayScale - 0.8) < 1e-6);
        QVERIFY(std::abs(same.chestScale - 0.8) < 1e-6);
        QCOMPARE(same.figures.size(), std::size_t{11});
        for (const Deviation& f : same.figures)
            QVERIFY2(std::abs(f.deviation()) < 1e-3, f.name.c_str());
        QCOMPARE(same.organs.size(), std::size_t{9});
        for (const OrganDistance& organ : same.organs)
            QVERIFY2(organ.mean_mm() < 1e-3, organ.organ.c_str());
        QVERIFY(same.notInSet.empty() && same.notInPatient.empty());
        QVERIFY(same.met());
        QVERIFY(reportOf(same)[QStringLiteral("unmet")].toArray().isEmpty());
    }

    void saysByHowMuchEachFigureDeviates()
    {
        test::KnownAirway real;
        real.length = 0.110;
        real.coronal = 0.024;
        real.sagittal = 0.032;
        real.leftAngle = 40.0;
        real.teeth = 0.236;
        const AnatomyComparison c = against(real);
        QVERIFY(std::abs(figure(c, "trachea_length_mm").deviation() + 1.0 / 11.0) < 1e-5);
        QVERIFY(figure(c, "trachea_length_mm").met());
        QVERIFY(std::abs(figure(c, "trachea_coronal_mm").deviation() + 1.0 / 6.0) < 1e-5);
        QVERIFY(!figure(c, "trachea_coronal_mm").met());
        QVERIFY(std::abs(figure(c, "trachea_sagittal_mm").deviation() + 0.5) < 1e-5);
        QVERIFY(figure(c, "trachea_sagittal_mm").met()); // of any depth
        QVERIFY(std::abs(figure(c, "left_bronchus_deg").deviation() - 6.0) < 0.02);
        QVERIFY(!figure(c, "left_bronchus_deg").met());
        QVERIFY(figure(c, "right_bronchus_deg").met());
        QVERIFY(std::abs(figure(c, "teeth_to_carina_mm").deviation() + 6.0) < 1e-3);
        QVERIFY(!figure(c, "teeth_to_carina_mm").met());
        QVERIFY(!c.met());
        QCOMPARE(reportOf(c)[QStringLiteral("unmet")].toArray().size(), 3);
    }

    void comparesTheSharesOfTheLobes()
    {
        test::KnownAirway real;
        real.lobes_ml = {240.0, 100.0, 210.0, 220.0, 230.0};
        const AnatomyComparison c = against(real);
        QVERIFY(std::abs(figure(c, "right_upper_lobe_percent").deviation() + 4.0) < 1e-3);
        QVERIFY(!figure(c, "right_upper_lobe_percent").met());
        QVERIFY(std::abs(figure(c, "left_lower_lobe_percent").generated - 23.0) < 1e-3);
        QVERIFY(figure(c, "left_lower_lobe_percent").met());
        Anatomy withoutOne = test::anatomyOf({});
        withoutOne.parts.pop_back();
        QVERIFY(!lobeShares(withoutOne));
    }

    void measuresOrgansApart()
    {
        Anatomy real = test::anatomyOf({});
        for (AnatomyPart& part : real.parts)
            if (part.role == PartRole::Trachea)
                part.levels.front() =
                    test::tubeOf(Vec3{0.0, 0.02, 0.0}, Vec3{0.0, 0.02, 0.1}, 0.01, 0.008);
        real.parts.push_back(named("Tongue", PartRole::Tongue));
        Anatomy made = test::anatomyOf({});
        made.parts.push_back(named("Skin", PartRole::Skin));
        const auto c = compareAnatomy(made, real);
        QVERIFY(c.has_value());
        const auto& trachea = *std::ranges::find(c->organs, "trachea", &OrganDistance::organ);
        QVERIFY(trachea.mean_mm() > 6.0);
        QVERIFY(!trachea.met());
        QCOMPARE(c->notInSet, std::vector<std::string>{"skin"});
        QCOMPARE(c->notInPatient, std::vector<std::string>{"tongue"});
    }

    void countsOneWayWhereTheSetGoesOn()
    {
        const OrganDistance both{.organ = "a", .toReal_mm = 5.0, .fromReal_mm = 9.0};
        QCOMPARE(both.mean_mm(), 7.0);
        QVERIFY(!both.met());
        const OrganDistance one{.organ = "a", .toReal_mm = 5.0, .fromReal_mm = 9.0, .oneWay = true};
        QCOMPARE(one.mean_mm(), 5.0);
        QVERIFY(one.met());
    }

    void findsSurfacesThatRunThroughThemselves()
    {
        Anatomy anatomy = test::anatomyOf({});
        QVERIFY(selfIntersectionsOf(anatomy).empty());
        TriangleMesh crossed = test::boxOf(Vec3::Zero(), Vec3::Ones());
        append(crossed, test::boxOf({0.43, 0.31, 0.22}, {1.38, 1.51, 1.74}));
        anatomy.parts.push_back(
            {"Crossed", PartRole::Other, {}, {named("", {}).levels[0], crossed}});
        const auto found = selfIntersectionsOf(anatomy);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].part, std::string{"Crossed"});
        QCOMPARE(found[0].level, std::size_t{1});
        QVERIFY(found[0].pairs >= 6);
        QCOMPARE(listOf(found)[0][QStringLiteral("part")].toString(), QStringLiteral("Crossed"));
    }

    void sortsPartsIntoOrgans_data()
    {
        QTest::addColumn<PartRole>("role");
        QTest::addColumn<std::string>("organ");
        const auto row = [](const char* name, PartRole role, const char* organ) {
            QTest::newRow(name) << role << std::string{organ};
        };
        row("Thyroid cartilage", PartRole::Larynx, "larynx");
        row("Left vocal ligament", PartRole::Larynx, "larynx");
        row("Left vocalis", PartRole::Larynx, "");
        row("Left fifth rib", PartRole::Rib, "ribs");
        row("Left fifth costal cartilage", PartRole::Rib, "ribs");
        row("Body of sternum", PartRole::Rib, "sternum");
        row("Manubrium", PartRole::Rib, "sternum");
        row("Right clavicle", PartRole::Rib, "clavicles");
        row("Right scapula", PartRole::Rib, "");
        row("Atlas", PartRole::Spine, "cervical spine");
        row("Axis", PartRole::Spine, "cervical spine");
        row("Seventh cervical vertebra", PartRole::Spine, "cervical spine");
        row("Second thoracic vertebra", PartRole::Spine, "thoracic spine");
        row("Intervertebral disk of second thoracic vertebra", PartRole::Spine, "");
        row("Tongue", PartRole::Tongue, "tongue");
        row("Left genioglossus", PartRole::Tongue, "");
        row("Left inferior pharyngeal constrictor", PartRole::Pharynx, "pharynx");
        row("Left tensor veli palatini", PartRole::Pharynx, "");
        row("Soft palate", PartRole::Pharynx, "soft palate");
        row("Heart", PartRole::Heart, "");
        row("Left upper canine tooth", PartRole::Tooth, "teeth");
    }
    void sortsPartsIntoOrgans()
    {
        QFETCH(PartRole, role);
        QFETCH(std::string, organ);
        QCOMPARE(organOf(QTest::currentDataTag(), role), organ);
    }

    void saysWhoseAirwayCannotBeMeasured()
    {
        Anatomy empty;
        empty.name = "Nobody";
        const auto c = compareAnatomy(test::anatomyOf({}), empty);
        QCOMPARE(c.error(), (Error{Errc::NothingRecognised, "the airway of Nobody"}));
    }
};

CARINA_TEST(TestAnatomyComparison)

} // namespace carina::lab::anatomy_comparison_test

#include "tst_anatomy_comparison.moc"
