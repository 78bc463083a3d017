#include "apps/lab/tracking/polaris_sight.h"

#include "apps/lab/commands.h"
#include "tests/evaluation/polaris/rom_file.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::lab::polaris_sight_test
{
namespace
{

using namespace std::chrono_literals;

constexpr std::size_t kStylus = 3; // of the scripted tools

/// What is seen where the stylus has these markers.
Result<SeenPose> sightWith(const test::RomFile& stylus)
{
    const auto words = Words::read(polarisCommand(), {QStringLiteral("DIR")});
    auto tools = polarisTools(*words, scriptedTools(), {});
    if (!tools)
        return tl::unexpected(tools.error());
    const auto known = polarisTool(stylus.bytes());
    if (!known)
        return tl::unexpected(known.error());
    tools->known["stylus"] = *known;
    return scriptedSight(*words, *tools);
}

/// The time of an exposure.
LocalTime exposure(int number) { return LocalTime{5s} + fromSeconds(number / 60.0); }

} // namespace

class PolarisSightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The stylus is parked: its distance from the tracker follows from where patientBeforeTracker
    /// and ScriptedHands put both, 1.25 m from the centre of the scene and beside the cheek. The
    /// markers have 0.1 mm of noise, so that no two poses are alike.
    void statesWhatTheSimulatedTrackerMeasures()
    {
        constexpr double kDistance_mm = 1242.3;
        const auto sight = sightWith({});
        QVERIFY2(sight, sight ? "" : sight.error().detail.c_str());
        std::vector<Vec3> places_mm;
        double misfit_mm = 0.0;
        for (int i = 0; i < 300; ++i) {
            const auto pose = (*sight)(kStylus, exposure(i));
            QVERIFY(pose);
            places_mm.push_back(pose->p_mm);
            misfit_mm += pose->error_mm / 300.0;
        }
        Vec3 mean_mm = Vec3::Zero();
        for (const Vec3& place : places_mm)
            mean_mm += place / 300.0;
        double square = 0.0;
        for (const Vec3& place : places_mm)
            square += (place - mean_mm).squaredNorm() / 300.0;
        QVERIFY2(std::abs(mean_mm.norm() - kDistance_mm) < 0.5,
                 qPrintable(QString::number(mean_mm.norm())));
        QVERIFY2(std::sqrt(square) > 0.01 && std::sqrt(square) < 0.3,
                 qPrintable(QString::number(std::sqrt(square))));
        QVERIFY2(misfit_mm > 0.01 && misfit_mm < 0.2, qPrintable(QString::number(misfit_mm)));
    }

    void aToolIsSeenWhileItsMarkersFaceTheDevice_data()
    {
        QTest::addColumn<double>("left");
        QTest::addColumn<bool>("isSeen");
        QTest::newRow("to the patient's left, where the tracker is") << 1.0 << true;
        QTest::newRow("to the right") << -1.0 << false;
    }

    void aToolIsSeenWhileItsMarkersFaceTheDevice()
    {
        QFETCH(const double, left);
        QFETCH(const bool, isSeen);
        const auto sight = sightWith({.normal = left * Vec3::UnitX()});
        QVERIFY2(sight, sight ? "" : sight.error().detail.c_str());
        for (int i = 0; i < 60; ++i)
            QCOMPARE((*sight)(kStylus, exposure(i)).has_value(), isSeen);
        QVERIFY((*sight)(0, exposure(60))); // the head
    }
};

CARINA_TEST(PolarisSightTest)

} // namespace carina::lab::polaris_sight_test

#include "tst_polaris_sight.moc"
