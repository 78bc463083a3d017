#include "apps/program/tracker_change.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/tracker/sending_device.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QDateTime>
#include <QSaveFile>
#include <QTimer>
#include <QWidget>

#include <cmath>

namespace carina::tracker_change_test
{
namespace
{

using test::FakeSessionNode;
using test::SendingDevice;
using test::soon;

const SharedPatientModel& patient()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return made;
}

/// A site with a chin probe before the first device and a head before another one, x_mm from it
/// along x; the patient lies at the first.
QByteArray siteText(const char* second, double x_mm, const char* more = "")
{
    // moc does not read a raw string that ends within quotes.
    return QByteArray{R"({"schema": "carina.site/3", "step": "overview", "devices": [
    {"file": "chin.json"}, {"file": "SECOND", "frame": {"X_TD_mm": [[1, 0, 0, X_MM],
     [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "late_ms": 0, "rms_mm": 0.4, "rms_deg": 0.1,
     "pairs": 400, "calibrated_at": "2026-11-01T10:00:00Z"}}],
 "catalogue": {"name": "three", "landmarks": [{"name": "a", "p_AQ_mm": [0, 0, 1]},
  {"name": "b", "p_AQ_mm": [0, 1, 0]}, {"name": "c", "p_AQ_mm": [1, 0, 0]}]},
 "registration": {"X_AM_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "X_AT_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "rms_mm": 0.1, "residuals_mm": [{"name": "a", "mm": 0.1}] MORE}})"}
        .replace("MORE", more)
        .replace("SECOND", second)
        .replace("X_MM", QByteArray::number(x_mm));
}

QByteArray description(const SendingDevice& device, const char* role)
{
    return QByteArray{R"({"schema": "carina.tracker/1", "kind": "openigtlink",
 "address": "ADDRESS", "tools": [{"name": "NAME", "role": "ROLE", "device": "NAME"}]})"}
        .replace("ADDRESS", QByteArray::fromStdString(device.address()))
        .replace("NAME", QByteArray::fromStdString(device.name))
        .replace("ROLE", role);
}

/// A program that runs at a site of two devices, and the wizard that writes its file.
struct Running {
    Running()
    {
        folder.write("chin.json", description(chin, "jaw"));
        folder.write("head.json", description(head, "head"));
        folder.write("visor.json", description(visor, "head"));
        write(siteText("head.json", 100.0));
    }

    /// As the wizard does: a whole file takes the place of the one before, later than it.
    void write(const QByteArray& text, int later_s = 1)
    {
        QSaveFile file{site};
        written = written.addSecs(later_s);
        const bool isWritten =
            file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.flush()
            && file.setFileTime(written, QFileDevice::FileModificationTime) && file.commit();
        QVERIFY(isWritten);
    }

    test::ScratchFolder folder;
    QString site = folder.filePath("site.json");
    QDateTime written{{2026, 11, 1}, {10, 0}, Qt::UTC};
    SendingDevice chin{.name = "Chin"};
    SendingDevice head{.name = "Head"};
    SendingDevice visor{.name = "Visor"};
};

/// Its tools, and what may change them.
struct Tools {
    explicit Tools(const QString& site, const std::optional<TrackerChoice>& tracker,
                   bool isOfSite = true)
        : change{{.site = site, .tracker = tracker, .isOfSite = isOfSite}},
          tools{node, {.tracker = tracker}, [this](const PatientModel& of) {
                    return change.placeOf(of);
                }}
    {
    }

    program::TrackerChange change;
    FakeSessionNode node{FakeSessionNode::kTrainee};
    SharedTools tools;
    QWidget window;

    [[nodiscard]] std::vector<TrackedTool> tracked() const
    {
        return tools.tracking() ? tools.tracking()->tracker().tools() : std::vector<TrackedTool>{};
    }
    /// Whether the second device stands so far along x.
    [[nodiscard]] bool isSecondAt(double x_mm) const
    {
        const auto all = tracked();
        const auto X_TD = all.size() == 2 ? all[1].history->deviceFrame() : std::nullopt;
        return X_TD && std::abs(1e3 * X_TD->translation().x() - x_mm) < 1e-6;
    }
};

std::optional<TrackerChoice> named(const Running& running)
{
    return trackerOfSite(running.site.toStdString()).value();
}

} // namespace

class TestTrackerChange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOverTheFrameOfADeviceThatWasCalibratedAnew()
    {
        Running running;
        Tools program{running.site, named(running)};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        QVERIFY(program.isSecondAt(100.0));
        const auto before = program.tracked();
        running.write(siteText("head.json", 200.0));
        QVERIFY(soon([&] { return program.isSecondAt(200.0); }));
        const auto after = program.tracked();
        QCOMPARE(after[0].history, before[0].history); // which runs on
        QCOMPARE(after[1].history, before[1].history);
    }

    /// As a verification does that becomes too old: here the file changes without a later time.
    void judgesTheRegistrationAgainThoughNothingWasWritten()
    {
        Running running;
        Tools program{running.site, named(running)};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        QVERIFY(program.tools.standing()->state == RegistrationState::Unverified);
        running.write(siteText("head.json", 100.0, R"(, "stale": "manikin" )"), 0);
        auto* look = program.window.findChild<QTimer*>(QString{}, Qt::FindDirectChildrenOnly);
        QVERIFY(look != nullptr);
        QVERIFY(look->intervalAsDuration() == program::TrackerChange::kLook);
        look->setInterval(0);
        QVERIFY(soon([&] { return program.tools.standing()->state == RegistrationState::Stale; }));
    }

    void takesOverADeviceThatWasReplaced()
    {
        Running running;
        Tools program{running.site, named(running)};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        const auto before = program.tracked();
        QCOMPARE(before[1].name, std::string{"Head"});
        running.write(siteText("visor.json", 100.0));
        QVERIFY(soon([&] { return program.tracked()[1].name == "Visor"; }));
        QCOMPARE(program.tracked()[0].history, before[0].history);
        QVERIFY(soon([&] { return running.visor.server->clients() == 1; }));
        QVERIFY(soon([&] { return running.head.server->clients() == 0; }));
    }

    /// As a program that is started then.
    void takesOverDevicesThatASiteNamesLater()
    {
        Running running;
        Tools program{running.site, std::nullopt};
        QVERIFY(program.tools.lay(patient()));
        QVERIFY(program.tracked().empty());
        program.change.watch(program.window, program.tools);
        QCOMPARE(program.tracked().size(), std::size_t{2});
    }

    void goesOnWithTheDevicesOfASiteThatCannotBeRead()
    {
        Running running;
        Tools program{running.site, named(running)};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        const auto before = program.tracked();
        running.write("no site");
        QVERIFY(
            soon([&] { return program.tools.standing()->state == RegistrationState::Missing; }));
        QCOMPARE(program.tracked()[1].history, before[1].history);
        QVERIFY(QFile::remove(running.site));
        running.write(siteText("head.json", 300.0));
        QVERIFY(soon([&] { return program.isSecondAt(300.0); }));
    }

    /// Here none, also in the next session.
    void leavesWhatAPersonChose()
    {
        Running running;
        Tools program{running.site, named(running)};
        QVERIFY(program.tools.lay(patient()));
        {
            QObject session;
            program.change.watch(session, program.tools);
            program.change.take(program.window, program.tools);
            QVERIFY(program.tracked().empty());
        }
        running.write(siteText("head.json", 200.0));
        program.change.watch(program.window, program.tools); // which looks at once
        QVERIFY(program.tracked().empty());
    }

    /// The simulated tracker needs no site.
    void theSiteOfOneTrackerIsNotThatOfTheNext()
    {
        Running running;
        Tools program{{}, std::nullopt, false};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        const TrackerChoice device{running.chin.described(ToolRole::Jaw).described};
        program.change.use(program.window, program.tools, device, running.site);
        QVERIFY(program.tools.standing()->state == RegistrationState::Unverified);
        const TrackerChoice simulated{SimulatedDevice{}};
        program.change.use(program.window, program.tools, simulated);
        QVERIFY(program.tools.standing()->state == RegistrationState::Simulated);
    }

    void theSiteOfTheStartHoldsForEachTracker()
    {
        Running running;
        Tools program{running.site, std::nullopt, false};
        QVERIFY(program.tools.lay(patient()));
        program.change.use(program.window, program.tools, TrackerChoice{SimulatedDevice{}});
        QVERIFY(program.tools.standing()->state == RegistrationState::Unverified);
    }

    void leavesTheTrackerThatWasNamedBesideTheSite()
    {
        Running running;
        const TrackerChoice beside{running.chin.described(ToolRole::Jaw).described};
        Tools program{running.site, beside, false};
        QVERIFY(program.tools.lay(patient()));
        program.change.watch(program.window, program.tools);
        QCOMPARE(program.tracked().size(), std::size_t{1});
    }
};

CARINA_SCREEN_TEST(TestTrackerChange)

} // namespace carina::tracker_change_test

#include "tst_tracker_change.moc"
