#include "models/registration/device_task.h"

#include "engine/io/site/site_file.h"
#include "models/site/site_tasks.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/models/registration/made_site.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <fstream>

namespace carina::device_task_test
{
namespace
{

std::string server(const std::string& name, const std::string& role)
{
    return test::json("{'schema': 'carina.tracker/1', 'kind': 'openigtlink', 'address': "
                      "'192.0.2.8:18944', 'tools': [{'name': '"
                      + name + "', 'role': '" + role + "'}]}");
}

TrackerForm described(const std::filesystem::path& file)
{
    TrackerForm form;
    form.source = TrackerSource::Description;
    form.description = QString::fromStdString(file.string());
    return form;
}

FrameCalibration someFrame(double x)
{
    return {.place = {RigidTransform::translation({x, 0.2, -0.3}), std::chrono::milliseconds{12}},
            .rms = millimetres(0.6),
            .turn = degrees(0.3),
            .pairs = 812};
}

/// A site with a verified registration, and beside it what describes its devices: the stylus is one
/// of the second.
struct Workshop {
    QTemporaryDir folder;
    WrittenTracker tracker;
    SiteEditor editor{path("site.json"), test::verifiedSite(), [] {
                          return QDateTime{{2004, 3, 27}, {12, 0}, Qt::UTC};
                      }};

    Workshop()
    {
        write("first.json", server("Chin", "jaw"));
        write("added.json", server("Stylus", "stylus"));
        write("third.json", server("Board", "other"));
    }
    [[nodiscard]] std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path{folder.path().toStdString()} / name;
    }
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream{path(name)} << text;
    }
    [[nodiscard]] DeviceTask::Access access() const
    {
        return {.tracker = &tracker, .trackerName = QStringLiteral("Written tracker"), .clock = [] {
                    return std::optional{SessionTime{}};
                }};
    }
    /// With its first and a second device, calibrated a while ago.
    void haveTwo(DeviceTask& task, const std::string& second = "added.json") const
    {
        task.setFirst({"first.json"});
        task.store({second}, someFrame(1.0));
        task.follow();
    }
    [[nodiscard]] Site stored() const { return readSiteFile(path("site.json")).value(); }
    [[nodiscard]] SiteTask taskOf(SiteStep step) const
    {
        return siteTask(editor.site(), step, test::kTool, QString::fromStdString(test::kTracker),
                        editor.today());
    }
};

std::optional<std::string> keptIn(DeviceTask& task, const TrackerForm& form)
{
    const auto choice = choiceOf(form);
    return choice ? task.kept(form, *choice) : std::nullopt;
}

} // namespace

class TestDeviceTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void storesDevicesAndHowTheyWereCalibrated()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        QVERIFY(task.rows().empty());
        QVERIFY(task.isFirst({"first.json"}));
        workshop.haveTwo(task);
        QVERIFY2(workshop.editor.problem().isEmpty(), qPrintable(workshop.editor.problem()));
        const Site stored = workshop.stored();
        QCOMPARE(stored.devices.size(), 2U);
        QCOMPARE(stored.devices[0].file, std::string{"first.json"});
        const SiteDeviceFrame& frame = *stored.devices[1].frame;
        QVERIFY((frame.place.X_FD.translation() - Vec3{1.0, 0.2, -0.3}).norm() < 1e-9);
        QCOMPARE(frame.place.late, Duration{std::chrono::milliseconds{12}});
        QCOMPARE(frame.calibratedAt, std::string{"2004-03-27T12:00:00Z"});
        const auto rows = task.rows();
        QCOMPARE(rows.size(), 2U);
        QCOMPARE(rows[0].name, QStringLiteral("OpenIGTLink server at 192.0.2.8:18944"));
        QVERIFY2(rows[1].calibrated.contains(QStringLiteral("2004-03-27"))
                     && rows[1].calibrated.contains(QStringLiteral("0.6\u00a0mm and 0.3°"))
                     && rows[1].calibrated.contains(QStringLiteral("12.0\u00a0ms")),
                 qPrintable(rows[1].calibrated));
        QVERIFY2(rows[1].state.contains(QStringLiteral("Written tracker")),
                 qPrintable(rows[1].state));
    }

    /// One program more on the same file: nothing is held back until the end.
    void isStillThereForTheNextProgram()
    {
        Workshop workshop;
        {
            DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
            workshop.haveTwo(task);
            QVERIFY(task.toCalibrate({"third.json"})); // and the program is killed meanwhile
        }
        SiteEditor again{workshop.path("site.json"), workshop.stored(),
                         &QDateTime::currentDateTimeUtc};
        const DeviceTask task{again, workshop.path("site.json"), workshop.access()};
        QCOMPARE(task.rows().size(), 2U);
    }

    void makesARegistrationStaleThatRestsOnADeviceCalibratedAgain()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        workshop.haveTwo(task);
        QCOMPARE(workshop.taskOf(SiteStep::Verify).state, TaskState::Done);
        task.store({"added.json"}, someFrame(1.1));
        for (const SiteStep step : {SiteStep::Touch, SiteStep::Fit, SiteStep::Verify}) {
            const SiteTask stale = workshop.taskOf(step);
            QCOMPARE(stale.state, TaskState::Stale);
            QVERIFY2(stale.why.contains(QStringLiteral("frame of one of its devices")),
                     qPrintable(stale.why));
        }
        QCOMPARE(workshop.stored().registration->stale, std::optional{StaleCause::Tracker});
        workshop.editor.undo();
        QCOMPARE(workshop.taskOf(SiteStep::Verify).state, TaskState::Done);
        QCOMPARE(workshop.stored().devices[1].frame->place.X_FD.translation().x(), 1.0);
    }

    void keepsARegistrationThatDoesNotRestOnTheDevice()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        workshop.haveTwo(task, "third.json");
        task.store({"third.json"}, someFrame(1.1));
        task.remove(1);
        QCOMPARE(task.count(), 1U);
        QCOMPARE(workshop.taskOf(SiteStep::Verify).state, TaskState::Done);
    }

    void removesADeviceAndTakesThatBack()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        workshop.haveTwo(task);
        QVERIFY(!task.whyKept(0).isEmpty());
        task.remove(0); // the other one is calibrated to it
        QCOMPARE(workshop.editor.problem(), task.whyKept(0));
        QCOMPARE(workshop.stored().devices.size(), 2U);
        QVERIFY(task.whyKept(1).isEmpty());
        task.remove(1);
        QCOMPARE(workshop.stored().devices.size(), 1U);
        QCOMPARE(workshop.taskOf(SiteStep::Fit).state, TaskState::Stale);
        workshop.editor.undo();
        QCOMPARE(workshop.stored().devices.size(), 2U);
        QCOMPARE(workshop.taskOf(SiteStep::Fit).state, TaskState::Done);
    }

    void replacesADeviceInOneChange()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        workshop.haveTwo(task);
        workshop.write("other.json", server("Stylus", "stylus")); // the same tools
        const DeviceTask::Wanted wanted{"other.json", 1};
        QVERIFY(!task.isFirst(wanted));
        const auto devices = task.toCalibrate(wanted);
        QVERIFY2(devices, qPrintable(workshop.editor.problem()));
        QCOMPARE(devices->second.tools[0].name, std::string{"Stylus"});
        task.store(wanted, someFrame(2.0));
        QCOMPARE(workshop.stored().devices.size(), 2U);
        QCOMPARE(workshop.stored().devices[1].file, std::string{"other.json"});
        workshop.editor.undo();
        QCOMPARE(workshop.stored().devices[1].file, std::string{"added.json"});
    }

    void refusesDevicesThatSeeTheSameTool()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        workshop.haveTwo(task);
        workshop.write("other.json", server("Stylus", "other"));
        QVERIFY(!task.toCalibrate({"other.json"}));
        QVERIFY2(workshop.editor.problem().contains(QStringLiteral("Stylus")),
                 qPrintable(workshop.editor.problem()));
    }

    void takesADescriptionBesideTheSiteAsItIs()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        QCOMPARE(keptIn(task, described(workshop.path("first.json"))),
                 std::optional{std::string{"first.json"}});
        workshop.haveTwo(task);
        QVERIFY(!keptIn(task, described(workshop.path("added.json")))); // it is there already
        QVERIFY2(workshop.editor.problem().contains(QStringLiteral("already")),
                 qPrintable(workshop.editor.problem()));
    }

    void writesADescriptionFromElsewhereBesideTheSite()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        const QTemporaryDir elsewhere;
        const std::filesystem::path file =
            elsewhere.filePath(QStringLiteral("theirs.json")).toStdString();
        std::ofstream{file} << server("Tube", "tube");
        QCOMPARE(keptIn(task, described(file)), std::optional{std::string{"tracker.json"}});
        QCOMPARE(readTrackerFile(workshop.path("tracker.json")).value().tools[0].name,
                 std::string{"Tube"});
    }

    void refusesWhatIsNoDeviceOfASite()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        QVERIFY(!task.kept({}, {SimulatedDevice{}}));
        QVERIFY(!workshop.editor.problem().isEmpty());
        TrackerDescription camera{.address = "/dev/video0"};
        camera.kind = TrackerKind::Camera;
        const QTemporaryDir elsewhere;
        QVERIFY(!task.kept(
            described(elsewhere.filePath(QStringLiteral("camera.json")).toStdString()), {camera}));
        QVERIFY2(workshop.editor.problem().contains(workshop.folder.path()),
                 qPrintable(workshop.editor.problem()));
    }

    void describesAWebcamBesideTheSite()
    {
        Workshop workshop;
        DeviceTask task{workshop.editor, workshop.path("site.json"), workshop.access()};
        const TrackerForm form{.source = TrackerSource::Webcam, .webcam = QStringLiteral("0")};
        QCOMPARE(task.kept(form, choiceOf(form).value()),
                 std::optional{std::string{"tracker.json"}});
        const auto written = readTrackerFile(workshop.path("tracker.json"));
        QVERIFY2(written, written ? "" : written.error().detail.c_str());
        QCOMPARE(written->address, std::string{"/dev/video0"});
    }

    /// A program that tracks with the site's devices has to do so anew once they are others.
    void tellsThatTheTrackerIsOutdated()
    {
        Workshop workshop;
        DeviceTask::Access access = workshop.access();
        access.tracked = std::vector<SiteDevice>{{.file = "first.json"}};
        DeviceTask task{workshop.editor, workshop.path("site.json"), access};
        QVERIFY(task.isOutdated());
        task.setFirst({"first.json"});
        QVERIFY(task.isTracked() && !task.isOutdated());
        task.store({"third.json"}, someFrame(1.0));
        QVERIFY(!task.isTracked() && task.isOutdated());
        workshop.editor.undo();
        QVERIFY(task.isTracked());
        const DeviceTask other{workshop.editor, workshop.path("site.json"), workshop.access()};
        QVERIFY(!other.isTracked() && !other.isOutdated()); // it tracks with something else
    }

    void givesItsDevicesFreeForACalibration()
    {
        Workshop workshop;
        DeviceTask::Access access = workshop.access();
        std::vector<bool> asked;
        access.track = [&asked](bool tracks) -> Result<void> {
            asked.push_back(tracks);
            return {};
        };
        DeviceTask task{workshop.editor, workshop.path("site.json"), access};
        QVERIFY(task.lend());
        task.takeBack();
        QCOMPARE(asked, (std::vector<bool>{false, true}));
    }
};

CARINA_TEST(TestDeviceTask)

} // namespace carina::device_task_test

#include "tst_device_task.moc"
