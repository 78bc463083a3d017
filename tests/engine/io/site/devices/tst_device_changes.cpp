#include "engine/io/site/devices/device_changes.h"

#include "engine/geometry/rotation.h"
#include "engine/io/site/devices/site_devices.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <algorithm>
#include <fstream>

namespace carina::device_changes_test
{
namespace
{

using Stale = std::optional<StaleCause>;

SiteDevice calibrated(const std::string& file, double x)
{
    return {.file = file,
            .frame = SiteDeviceFrame{.place = {RigidTransform::translation({x, 0.0, 0.0})},
                                     .pairs = 100,
                                     .calibratedAt = "2026-11-24T10:00:00Z"}};
}

/// A server with tools of these roles, by names of their own.
std::string server(const std::string& name, const std::vector<std::string>& roles)
{
    std::string tools;
    for (const std::string& role : roles)
        tools += (tools.empty() ? "" : ", ") + ("{'name': '" + name + role + "', 'role': '" + role)
                 + "'}";
    return test::json("{'schema': 'carina.tracker/1', 'kind': 'openigtlink', 'address': "
                      "'192.0.2.8:18944', 'tools': ["
                      + tools + "]}");
}

/// Registered with a chin and a body probe, both tools calibrated, nothing stale.
Site freshSite()
{
    Site site = test::wholeSite();
    for (TouchedPoint& touch : site.touched)
        touch.stale.reset();
    for (SiteTool& tool : site.tools)
        tool.stale.reset();
    site.registration->stale.reset();
    site.verification->stale.reset();
    site.relay = site.touched;
    site.devices = {{.file = "first.json"}, calibrated("added.json", 1.0)};
    return site;
}

/// What is out of date: by letters, so that a line of the table says it all.
std::string staleOf(const Site& site)
{
    const Stale tracker = StaleCause::Tracker;
    std::string all;
    if (std::ranges::all_of(site.touched,
                            [&](const TouchedPoint& touch) { return touch.stale == tracker; }))
        all += "touches ";
    if (site.registration->stale == tracker && site.verification->stale == tracker)
        all += "registration ";
    for (const SiteTool& tool : site.tools)
        if (tool.stale == tracker)
            all += tool.role == ToolRole::Tube ? "tube " : "laryngoscope ";
    if (!site.relay)
        all += "relay ";
    return all.empty() ? all : all.substr(0, all.size() - 1);
}

} // namespace

/// What rests on a device is out of date once its frame is another one.
class TestDeviceChanges : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    [[nodiscard]] std::filesystem::path folder() const { return m_folder.path().toStdString(); }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream{folder() / name} << text;
    }

private Q_SLOTS:
    void init()
    {
        write("first.json", server("a", {"other"}));
        write("added.json", server("b", {"other"}));
        write("third.json", server("c", {"other"}));
    }

    void marksWhatRestsOnTheDevice_data()
    {
        QTest::addColumn<std::vector<std::string>>("roles");
        QTest::addColumn<std::string>("stale");
        const auto row = [](const char* name, std::vector<std::string> roles,
                            const std::string& stale) {
            QTest::newRow(name) << std::move(roles) << stale;
        };
        row("no tool of the registration", {"head", "hand", "chest"}, "");
        row("the stylus", {"stylus"}, "touches registration tube laryngoscope relay");
        row("the chin probe", {"jaw"}, "registration");
        row("the body probe", {"manikin"}, "registration");
        row("a tube", {"tube"}, "tube");
        row("a laryngoscope", {"laryngoscope"}, "laryngoscope");
        row("a tube and the stylus it was touched with", {"stylus", "tube"},
            "touches registration laryngoscope relay");
    }
    void marksWhatRestsOnTheDevice()
    {
        QFETCH(std::vector<std::string>, roles);
        QFETCH(std::string, stale);
        write("added.json", server("b", roles));
        const auto anew = withDevice(freshSite(), folder(), calibrated("added.json", 1.5));
        QVERIFY2(anew, anew ? "" : anew.error().detail.c_str());
        QCOMPARE(staleOf(*anew), stale);
        QCOMPARE(anew->devices[1].frame->place.X_FD.translation().x(), 1.5);
        const auto without = withoutDevice(freshSite(), folder(), "added.json");
        QVERIFY(without);
        QCOMPARE(staleOf(*without), stale);
        QCOMPARE(without->devices.size(), 1U);
    }

    void keepsARegistrationThatFollowsNoProbe()
    {
        write("added.json", server("b", {"jaw", "manikin"}));
        Site site = freshSite();
        site.registration->X_JM.reset();
        site.registration->X_BM.reset();
        const auto anew = withDevice(site, folder(), calibrated("added.json", 1.5));
        QVERIFY(anew);
        QCOMPARE(staleOf(*anew), std::string{});
    }

    /// Whose tools nobody knows any more may have been any.
    void marksAllWhereADescriptionIsGone()
    {
        std::filesystem::remove(folder() / "added.json");
        const auto without = withoutDevice(freshSite(), folder(), "added.json");
        QVERIFY2(without, without ? "" : without.error().detail.c_str());
        QCOMPARE(staleOf(*without), std::string{"touches registration tube laryngoscope relay"});
    }

    void leavesAllAsItIsByAFurtherDevice()
    {
        write("third.json", server("c", {"stylus", "tube"}));
        const auto more = withDevice(freshSite(), folder(), calibrated("third.json", 2.0));
        QVERIFY2(more, more ? "" : more.error().detail.c_str());
        QCOMPARE(staleOf(*more), std::string{});
        QCOMPARE(more->devices.size(), 3U);
    }

    void refusesDevicesThatCannotBeUsedTogether()
    {
        write("third.json", server("b", {"other"})); // a tool of the same name
        const auto more = withDevice(freshSite(), folder(), calibrated("third.json", 2.0));
        QVERIFY(!more);
        QCOMPARE(more.error().code, Errc::FileMalformed);
        const auto nowhere = withDevice(freshSite(), folder(), calibrated("none.json", 2.0));
        QVERIFY(!nowhere);
        QCOMPARE(nowhere.error().code, Errc::FileNotFound);
    }

    void namesADeviceFromTheFolderOfTheSite()
    {
        QCOMPARE(deviceFile(folder(), folder() / "below" / "camera.json"),
                 std::string{"below/camera.json"});
    }
};

CARINA_TEST(TestDeviceChanges)

} // namespace carina::device_changes_test

#include "tst_device_changes.moc"
