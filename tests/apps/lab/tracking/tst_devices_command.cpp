#include "apps/lab/commands.h"
#include "engine/geometry/rotation.h"
#include "engine/io/site/site_file.h"
#include "engine/tracking/record/pose_record.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <cmath>
#include <fstream>

namespace carina::lab::devices_command_test
{
namespace
{

const RigidTransform kX_TD{rotationFromVector({0.4, -2.1, 0.7}), Vec3{1.2, -0.4, 2.1}};
const RigidTransform kX_OP{rotationFromVector({1.3, 0.2, -0.5}), Vec3{0.03, -0.08, 0.05}};
constexpr Duration kLate = std::chrono::milliseconds{22};

/// A body that a hand turns to and fro.
RigidTransform bodyAt(double t)
{
    return {rotationFromVector({0.5 * std::sin(3.1 * t), 0.3 * std::sin(4.7 * t + 1.0),
                                0.4 * std::sin(2.3 * t + 0.4)}),
            Vec3{0.2 * std::sin(0.9 * t), 0.15 * std::cos(1.4 * t), 1.5}};
}

/// A site with a description of each of two devices beside it, and what both saw.
class Workshop
{
public:
    Workshop()
    {
        describe("first.json", "Chin", "jaw");
        describe("added.json", "Board", "other");
        record("first.csv", "Chin", [](double t) { return bodyAt(t); }, {});
        record(
            "added.csv", "Board", [](double t) { return kX_TD.inverse() * bodyAt(t) * kX_OP; },
            kLate);
    }

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }
    [[nodiscard]] Result<QJsonObject> run(const QStringList& words) const
    {
        return devicesCommand().run(QStringList{path("site.json")} + words);
    }
    [[nodiscard]] Result<QJsonObject> add() const
    {
        return run({QStringLiteral("--add"), path("added.json"), QStringLiteral("--tool"),
                    QStringLiteral("Chin"), QStringLiteral("--tool-of-added"),
                    QStringLiteral("Board"), QStringLiteral("--recording"), path("first.csv"),
                    QStringLiteral("--recording-of-added"), path("added.csv")});
    }
    [[nodiscard]] Result<QJsonObject> first() const
    {
        return run({QStringLiteral("--first"), path("first.json")});
    }
    [[nodiscard]] Site site() const
    {
        return readSiteFile(path("site.json").toStdString()).value_or(Site{});
    }
    template <class BodyAt>
    void record(const char* name, const char* tool, const BodyAt& at, Duration late) const
    {
        std::ofstream file{path(name).toStdString()};
        file << pose_record::beginning();
        for (int i = 0; i < 900; ++i)
            file << pose_record::line(
                {.name = tool},
                {.time = SessionTime{fromSeconds(100.0 + i / 45.0) + late}, .X_FO = at(i / 45.0)});
    }

private:
    void describe(const char* name, const char* tool, const char* role) const
    {
        std::ofstream{path(name).toStdString()} << test::json(
            "{'schema': 'carina.tracker/1', 'kind': 'openigtlink', 'address': '192.0.2.8:18944', "
            "'tools': [{'name': '"
            + std::string{tool} + "', 'role': '" + role + "'}]}");
    }

    QTemporaryDir m_folder;
};

std::string why(const Result<QJsonObject>& result)
{
    return result ? std::string{} : result.error().detail;
}

} // namespace

class DevicesCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void storesHowASecondDeviceStandsToTheFirst()
    {
        const Workshop workshop;
        const auto first = workshop.first();
        QVERIFY2(first, why(first).c_str());
        const auto added = workshop.add();
        QVERIFY2(added, why(added).c_str());
        QCOMPARE((*added)[QStringLiteral("acceptable")], QJsonValue{true});
        const Site site = workshop.site();
        QCOMPARE(site.devices.size(), 2U);
        QCOMPARE(site.devices[0].file, std::string{"first.json"});
        QCOMPARE(site.devices[1].file, std::string{"added.json"});
        const DevicePlace& place = site.devices[1].frame->place;
        constexpr double kWithin_ms = 1.0; // of timeShift
        QVERIFY(std::abs(1e3 * toSeconds(place.late - kLate)) < kWithin_ms);
        constexpr double kWithin_deg = 0.1;
        QVERIFY(inDegrees(angleBetween(place.X_FD.rotation(), kX_TD.rotation())) < kWithin_deg);
        const Vec3 p_D = kX_TD.inverse() * Vec3{0.0, 0.0, 1.5};
        constexpr double kWithin_mm = 0.5;
        QVERIFY(1e3 * (place.X_FD * p_D - kX_TD * p_D).norm() < kWithin_mm);
    }

    void calibratesTheSameDeviceAnew()
    {
        const Workshop workshop;
        QVERIFY(workshop.first() && workshop.add() && workshop.add());
        QCOMPARE(workshop.site().devices.size(), 2U);
    }

    /// As where the tools were fixed to two bodies.
    void storesNothingThatDoesNotFit()
    {
        const Workshop workshop;
        QVERIFY(workshop.first());
        workshop.record(
            "added.csv", "Board",
            [](double t) {
                return kX_TD.inverse() * bodyAt(t)
                       * RigidTransform::translation({0.05 * std::sin(5.0 * t), 0.0, 0.0}) * kX_OP;
            },
            kLate);
        const auto added = workshop.add();
        QVERIFY2(added, why(added).c_str());
        QCOMPARE((*added)[QStringLiteral("acceptable")], QJsonValue{false});
        QCOMPARE(workshop.site().devices.size(), 1U);
    }

    void keepsTheFirstWhileOthersAreCalibratedToIt()
    {
        const Workshop workshop;
        QVERIFY(workshop.first() && workshop.add());
        QVERIFY(!workshop.first());
        QVERIFY(!workshop.run({QStringLiteral("--remove"), workshop.path("first.json")}));
        QVERIFY(workshop.run({QStringLiteral("--remove"), workshop.path("added.json")}));
        QVERIFY(workshop.run({QStringLiteral("--remove"), workshop.path("first.json")}));
        QVERIFY(workshop.site().devices.empty());
    }

    void namesTheToolsWhereOneIsNotThere()
    {
        const Workshop workshop;
        QVERIFY(workshop.first());
        const auto added = workshop.run(
            {QStringLiteral("--add"), workshop.path("added.json"), QStringLiteral("--tool"),
             QStringLiteral("Head"), QStringLiteral("--recording"), workshop.path("first.csv"),
             QStringLiteral("--recording-of-added"), workshop.path("added.csv")});
        QVERIFY(!added);
        QVERIFY2(why(added).ends_with("has no tool \"Head\"; it has \"Chin\""), why(added).c_str());
    }

    void refusesWhatIsNotEnough()
    {
        const Workshop workshop;
        QVERIFY(!devicesCommand().run({}));
        QVERIFY(!workshop.run({})); // there is no site
        QVERIFY(!workshop.add());   // nor a first device
        QVERIFY(workshop.first());
        QVERIFY(!workshop.run({QStringLiteral("--add"), workshop.path("added.json")}));
        QVERIFY(!workshop.run({QStringLiteral("--add"), workshop.path("first.json"),
                               QStringLiteral("--tool"), QStringLiteral("Chin")}));
        QVERIFY(!workshop.run({QStringLiteral("--first"), QStringLiteral("/etc/hostname")}));
    }
};

CARINA_TEST(DevicesCommandTest)

} // namespace carina::lab::devices_command_test

#include "tst_devices_command.moc"
