#include "engine/registration/landmarks/landmark_catalogue.h"

#include "engine/geometry/fit/rigid_fit.h"
#include "engine/registration/fit/site_frame.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::landmark_catalogue_test
{
namespace
{

LandmarkCatalogue three()
{
    return {"Some", "", {{"a", {0, 0, 1}}, {"b", {0, 1, 0}}, {"c", {1, 0, 0}}}};
}

} // namespace

class TestLandmarkCatalogue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesFourPlacesOnTheRibCage()
    {
        const LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), "abc");
        QVERIFY(checkCatalogue(catalogue));
        QCOMPARE(catalogue.name, std::string{"Rib cage"});
        QCOMPARE(catalogue.anatomy, std::string{"abc"});
        QCOMPARE(catalogue.landmarks.size(), 4U);
        QCOMPARE(catalogue.landmarks[0].name, std::string{"Sternal notch"});
        QCOMPARE(catalogue.landmarks[1].name, std::string{"Xiphoid process"});
        QVERIFY(catalogue.landmarks[2].name.starts_with("Left fifth rib"));
        QVERIFY(catalogue.landmarks[3].name.starts_with("Right fifth rib"));
    }

    /// Of any patient: notch above the carina, all in front of it, ribs to their sides at one
    /// height. The sternum of a grown man is 15 to 20 cm long.
    void liesAsARibCageDoes()
    {
        const auto q = ribCageCatalogue(metres(1.75), {}).landmarks;
        for (const Landmark& landmark : q)
            QVERIFY(landmark.p_AQ.y() < -0.04);
        QVERIFY(q[0].p_AQ.z() > 0.0);
        QVERIFY(q[2].p_AQ.x() > 0.06);
        QCOMPARE(q[3].p_AQ.x(), -q[2].p_AQ.x());
        QCOMPARE(q[3].p_AQ.z(), q[2].p_AQ.z());
        const double sternum = (q[0].p_AQ - q[1].p_AQ).norm();
        QVERIFY(sternum > 0.15 && sternum < 0.20);
    }

    void growsWithTheBody()
    {
        const auto grown = ribCageCatalogue(metres(1.8), {}).landmarks;
        const auto child = ribCageCatalogue(metres(1.2), {}).landmarks;
        for (std::size_t i = 0; i < grown.size(); ++i)
            QVERIFY((child[i].p_AQ - grown[i].p_AQ * (2.0 / 3.0)).norm() < 1e-12);
    }

    /// Of a grown man: the angles of the jaw are a decimetre apart, above the notch and behind the
    /// teeth; the tenth ribs end below the xiphoid process, at the sides. Touches of two places are
    /// told apart where they are 4 cm from each other.
    void addsPlacesOnJawAndTenthRibs()
    {
        const Length height = metres(1.75);
        const LandmarkCatalogue four = ribCageCatalogue(height, "abc");
        const LandmarkCatalogue eight = ribCageAndJawCatalogue(four, furtherPlaces(height));
        QVERIFY(checkCatalogue(eight));
        QCOMPARE(eight.name, std::string{"Rib cage and jaw"});
        QCOMPARE(eight.anatomy, four.anatomy);
        const auto& q = eight.landmarks;
        QCOMPARE(q.size(), 8U);
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(q[i], four.landmarks[i]);
        QCOMPARE(q[4].name, std::string{"Left angle of the jaw"});
        QCOMPARE(q[7].name, std::string{"End of the right tenth rib"});
        const double jaw = q[4].p_AQ.x() - q[5].p_AQ.x();
        QVERIFY(jaw > 0.09 && jaw < 0.12);
        QVERIFY(q[4].p_AQ.z() > q[0].p_AQ.z() + 0.1);
        QVERIFY(q[6].p_AQ.z() < q[1].p_AQ.z() - 0.1);
        QVERIFY(q[6].p_AQ.x() > 0.1 && q[6].p_AQ.x() < 0.15);
        for (std::size_t i = 4; i < 8; i += 2) {
            QCOMPARE(q[i + 1].p_AQ.x(), -q[i].p_AQ.x());
            QCOMPARE(q[i + 1].p_AQ.y(), q[i].p_AQ.y());
            QCOMPARE(q[i + 1].p_AQ.z(), q[i].p_AQ.z());
        }
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY((q[i].p_AQ - q[k].p_AQ).norm() > 0.04);
    }

    void canBeFittedAndMakesAFrame()
    {
        std::vector<LandmarkPair> pairs;
        std::vector<Vec3> points;
        for (const Landmark& landmark : ribCageCatalogue(metres(1.5), {}).landmarks) {
            pairs.push_back({landmark.p_AQ, landmark.p_AQ});
            points.push_back(landmark.p_AQ);
        }
        QVERIFY(fitRigid(pairs));
        QVERIFY(siteFrame(points));
    }

    void refusesACatalogueThatCannotBeUsed_data()
    {
        QTest::addColumn<LandmarkCatalogue>("catalogue");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("detail");
        LandmarkCatalogue faulty = three();
        faulty.landmarks.pop_back();
        QTest::newRow("two") << faulty << Errc::TooFewLandmarks
                             << QStringLiteral("2 landmarks, and 3 are the fewest");
        faulty = three();
        faulty.landmarks[1].name.clear();
        QTest::newRow("without a name")
            << faulty << Errc::OutOfRange << QStringLiteral("a landmark has no name");
        faulty.landmarks[1].name = faulty.landmarks[0].name;
        QTest::newRow("twice") << faulty << Errc::OutOfRange
                               << QStringLiteral("\"a\" is there twice");
        faulty = three();
        faulty.landmarks[2].p_AQ.z() = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no number")
            << faulty << Errc::NotFinite << QStringLiteral("c has a coordinate that is no number");
        faulty.landmarks[2].p_AQ.z() = -1e3;
        QTest::newRow("far") << faulty << Errc::OutOfRange
                             << QStringLiteral("c is a kilometre away or more");
    }

    void refusesACatalogueThatCannotBeUsed()
    {
        QFETCH(LandmarkCatalogue, catalogue);
        QFETCH(Errc, code);
        QFETCH(QString, detail);
        const auto checked = checkCatalogue(catalogue);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, code);
        QCOMPARE(QString::fromStdString(checked.error().detail), detail);
    }

    void takesThreeLandmarks() { QVERIFY(checkCatalogue(three())); }
};

CARINA_TEST(TestLandmarkCatalogue)

} // namespace carina::landmark_catalogue_test

#include "tst_landmark_catalogue.moc"
