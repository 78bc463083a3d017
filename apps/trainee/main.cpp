#include "apps/program/control_script.h"
#include "apps/program/join_question.h"
#include "apps/program/journal.h"
#include "apps/program/measurement.h"
#include "apps/program/options/entry_option.h"
#include "apps/program/options/openigtlink_option.h"
#include "apps/program/options/patient_option.h"
#include "apps/program/options/site_option.h"
#include "apps/program/options/tracker_option.h"
#include "apps/program/options/try_option.h"
#include "apps/program/program.h"
#include "apps/program/site_blade.h"
#include "apps/program/tracker_change.h"
#include "apps/program/tracker_question.h"
#include "apps/trainee/trainee_station.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/intubation/intubation_watch.h"
#include "models/patient/shared_patient.h"
#include "models/physiology/hands_model.h"
#include "models/station/own_station.h"
#include "models/vitals/sound_output.h"
#include "models/vitals/station_vitals.h"
#include "models/vitals/stethoscope.h"
#include "ui/tracker/recording_end.h"
#include "ui/trainee/trainee_window.h"
#include "widgets/scene/view/scene_view.h"

#include <QApplication>
#include <QPointer>
#include <QTimer>

#include <utility>

namespace carina
{
namespace
{

const QString kStationName = QStringLiteral("station");
const QString kManikinBreathes = QStringLiteral("manikin-breathes");

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(
        QApplication::translate("Trainee", "The trainee's view of a Carina session."));
    parser.addOption(
        {QStringLiteral("port"),
         QApplication::translate("Trainee", "UDP port of the session; the instructor's "
                                            "window shows it. Without it, or with a link but "
                                            "no name, a window asks."),
         QStringLiteral("P")});
    program::addEntryOptions(parser);
    // Not "name": Qt keeps that for itself.
    parser.addOption({QStringLiteral("as"),
                      QApplication::translate("Trainee", "The trainee's name in the session."),
                      QStringLiteral("NAME"), QApplication::translate("Trainee", "Trainee")});
    parser.addOption({QStringLiteral("observe"),
                      QApplication::translate("Trainee", "Join as an observer, who watches and "
                                                         "changes nothing.")});
    parser.addOption(
        {kStationName,
         QApplication::translate("Trainee", "Name of the station to come to. Without it: where the "
                                            "trainee was last, else the first that is open."),
         QStringLiteral("NAME")});
    parser.addOption(
        {kManikinBreathes,
         QApplication::translate("Trainee", "Breathing rate of the simulated manikin, breaths per "
                                            "minute; the patient breathes with it."),
         QStringLiteral("RATE")});
    parser.addOption(
        {QStringLiteral("output"),
         QApplication::translate("Trainee",
                                 "Kind of display: screen; mono or side-by-side for a headset."),
         QStringLiteral("KIND"), QStringLiteral("screen")});
    parser.addOption(
        {QStringLiteral("full-screen"), QApplication::translate("Trainee", "Fill the screen.")});
    program::addPatientOptions(parser);
    program::addSiteOption(parser);
    program::addTrackerOption(
        parser,
        QApplication::translate("Trainee", "All but the simulated one need --site. Without "
                                           "it the devices are used that the site names; where it "
                                           "names none, this program shows the session only."));
    program::addTryOptions(parser);
    program::addOpenIgtLinkOption(parser);
    program::addMeasureOptions(parser);
    program::addScriptOption(parser);
    program::addJournalOption(parser);
}

/// How long the newest action on the virtual patient took to arrive here; empty before there was
/// one.
QJsonObject actionReport(const SessionNode& node)
{
    const auto state = node.state();
    const SharedObject* patient = sharedPatient(*state, ownStation(node));
    for (const ObjectReport& report : node.objectReports())
        if (patient && report.object == patient->id && report.delay)
            return {{QStringLiteral("action_delay_ms"), 1e3 * toSeconds(*report.delay)}};
    return {};
}

/// Shows the window until it is closed, or measures it for as long as it was asked to.
int showUntilClosed(TraineeWindow& window, const QCommandLineParser& parser,
                    const program::MeasureOptions& options, TraineeStation& station)
{
    if (options.folder.isEmpty()) {
        window.resize(options.size);
        if (parser.isSet(QStringLiteral("full-screen")))
            window.showFullScreen();
        else
            window.show();
        return QApplication::exec();
    }
    window.resize(options.size);
    window.show();
    program::Measurement measurement{window, window.stationScene()};
    const auto compare = [&] {
        if (station.tools().truth())
            measurement.compareWith(station.tools().truth());
    };
    compare();
    QTimer end;
    end.setSingleShot(true);
    bool isLaid = false;
    station.onShown([&] {
        measurement.startAfresh();
        compare();
        if (!std::exchange(isLaid, true))
            end.start(); // the time asked for is that of something to see
    });
    end.callOnTimeout([&] {
        const auto wrote = measurement.write(QDir{options.folder}, QStringLiteral("trainee"),
                                             actionReport(station.node()));
        if (!wrote)
            return QApplication::exit(program::refuse(wrote.error()));
        const SessionNode& node = station.node();
        const bool isIn = node.self() != kNobody;
        QApplication::exit(
            isIn ? 0 : program::refuse(node.refusal().value_or(Error{Errc::HostSilent, {}})));
    });
    end.start(options.seconds * 1000);
    return QApplication::exec();
}

/// @param asks whether a person may be asked for the rest
Result<program::KnownEntry> entryOptions(const QCommandLineParser& parser, bool asks)
{
    program::KnownEntry entry{
        {.participantName = parser.value(QStringLiteral("as")).toStdString(),
         .role = parser.isSet(QStringLiteral("observe")) ? Role::Observer : Role::Trainee,
         .station = parser.value(kStationName).toStdString()}};
    const auto link = program::linkArgument(parser);
    if (!link)
        return tl::unexpected(link.error());
    if (const auto read = program::readEntryOptions(parser, entry.settings); !read)
        return tl::unexpected(read.error());
    entry.isNamed = parser.isSet(QStringLiteral("as"));
    // A link says all but the name.
    entry.isComplete =
        link->isEmpty() ? !parser.value(QStringLiteral("port")).isEmpty() : entry.isNamed;
    if (!entry.isComplete && asks) {
        entry.link = *link;
        return entry;
    }
    if (!link->isEmpty())
        return program::readLink(*link, entry.settings).map([&] { return entry; });
    return program::portOption(parser).map([&](std::uint16_t port) {
        entry.settings.port = port;
        return entry;
    });
}

/// Comes in; a person is asked for what is missing or refused, but not while this measures.
Result<program::Entered> enter(const program::KnownEntry& entry,
                               const program::MeasureOptions& options)
{
    if (options.folder.isEmpty())
        return program::askHowToJoin(entry);
    auto node = SessionNode::join(entry.settings);
    if (!node)
        return tl::unexpected(node.error());
    return program::Entered{*std::move(node), entry.settings.role};
}

/// The tracker of a trainee; none for an observer.
Result<SharedTools::Hardware> hardware(const QCommandLineParser& parser, Role role,
                                       std::optional<TrackerChoice> chosen)
{
    SharedTools::Hardware hardware;
    if (role == Role::Trainee)
        hardware.tracker = std::move(chosen);
    if (!parser.isSet(kManikinBreathes))
        return hardware;
    bool isNumber = false;
    const double rate = parser.value(kManikinBreathes).toDouble(&isNumber);
    if (!isNumber
        || !(rate >= inPerMinute(kSlowestManikin) && rate <= inPerMinute(kFastestManikin)))
        return fail(Errc::WrongOption, "--manikin-breathes needs a number from 4 to 60, not '"
                                           + parser.value(kManikinBreathes).toStdString() + "'");
    hardware.manikinBreathes = perMinute(rate);
    return hardware;
}

/// What a trainee's program is and sees by its options, whichever session it is in.
struct Outfit {
    program::MeasureOptions measure;
    ViewOutput output = ViewOutput::Screen;
    SharedPatientModel patient;    ///< shown until the session's is there
    program::TrackerChange change; ///< and the site
    std::optional<TrackerChoice> tracker;
    HeadsetView headset;
};

Result<Outfit> outfitFrom(const QCommandLineParser& parser, const program::MeasureOptions& measure,
                          ViewOutput output)
{
    if (const auto drawn = program::checkGraphics(); !drawn)
        return tl::unexpected(drawn.error());
    auto tracker =
        program::readSessionTracker(parser); // before a patient is made, which takes long
    if (!tracker)
        return tl::unexpected(tracker.error());
    const auto patient = program::choosePatient(parser);
    if (!patient)
        return tl::unexpected(patient.error());
    program::TrackerChange change{
        {.site = program::siteOption(parser),
         .tracker = *tracker,
         .isOfSite = !program::namesTracker(parser) || program::namesSiteDevices(parser),
         .conversation = program::recordDeviceOption(parser)}};
    const auto site = change.placeOf(*patient->model);
    if (!site)
        return tl::unexpected(site.error());
    const auto headset =
        HeadsetView::of(*site ? (*site)->display.value_or(defaultDisplay()) : defaultDisplay());
    if (!headset)
        return tl::unexpected(headset.error());
    return Outfit{measure, output, patient->model, std::move(change), *std::move(tracker),
                  *headset};
}

/// The window of the session that the program is in at present, for what works its controls.
class ShownWindow
{
public:
    void show(QWidget& window) { m_window = &window; }
    [[nodiscard]] QWidget& operator()() { return m_window ? *m_window : m_none; }

private:
    QWidget m_none; ///< between two sessions: has no controls
    QPointer<QWidget> m_window;
};

/// How one session was left.
struct Left {
    int status = 0;
    bool wantsAnother = false;
};

/// Takes part in a session until the person leaves it.
Result<Left> takePart(const QCommandLineParser& parser, Outfit& outfit, program::Entered entered,
                      ShownWindow& shown)
{
    program::TrackerChange& change = outfit.change;
    auto wanted = hardware(parser, entered.role, outfit.tracker);
    if (!wanted)
        return tl::unexpected(wanted.error());
    TraineeStation station{std::move(entered.node), *std::move(wanted),
                           [&change](const PatientModel& of) { return change.placeOf(of); }};
    SharedTools& tools = station.tools();
    PoseRecording recording{[node = &station.node()] { return node->now(); }};
    station.onShown([&] { tools.recordBy(recording); });
    if (const auto laid = tools.lay(outfit.patient); !laid)
        return tl::unexpected(laid.error());

    SessionModel session{station.node()};
    OwnStation place{session};
    station.setStation(place.id()); // it may have been let in meanwhile
    SharedObjectModel object{session, place.id()};
    ObjectActionModel actions{object};
    PeopleModel people{session, place.id()};
    TryWatch tries{session, place.id(), tools.posesOnScreen()};
    if (const auto judged = program::readTryOptions(parser, tries); !judged)
        return tl::unexpected(judged.error());
    SessionPatient sessionPatient{station.node(), place.id(), outfit.patient,
                                  AnatomyCache::defaultFolder()};
    StationVitals vitals{session, place.id(),
                         KeptSounds{program::dataFolder(parser), QStringLiteral("trainee")}};
    const SoundOutput sound{
        [&vitals](std::span<float> samples) { vitals.model().sounds().render(samples); }};
    HandsModel hands{session, place.id()};
    OfferSwitch offer{[&station] { return OfferGiver::Shown{station.view(), station.patient()}; }};
    TraineeWindow window{station.node(),
                         sessionPatient,
                         station.view(),
                         outfit.headset,
                         outfit.output,
                         tools.chinProbe(),
                         actions,
                         people,
                         tries,
                         [&tools] { return tools.standing(); },
                         program::programTracker(tools, recording, offer,
                                                 entered.role == Role::Trainee,
                                                 program::dataFolder(parser))};
    IntubationWatch watch{station.node(), place.id(), tools.posesOnScreen()};
    watch.readView([&window] { return window.glottisSeen(); });
    watch.readStanding([&tools] { return tools.standing(); });
    window.stationScene().bendTubeBy(
        [own = QPointer{&watch}](const StationMoment& moment, const TissueAround& tissue) {
            return own ? own->tubeAt(moment, tissue) : TubeInAirway{};
        });
    window.setMonitor(vitals.model(), sound);
    window.setHands(hands);
    vitals.setStethoscope([&window, hears = std::make_shared<Stethoscope>()] {
        const StationScene& scene = window.stationScene();
        return hears->heard(scene.patient(), scene.moment());
    });
    const auto show = [&] {
        window.show(station.patient(), station.view(), tools.chinProbe());
        window.stationScene().showBlade(program::bladeOf(tools));
        watch.lieIn(station.patient());
        watch.takeOwnBlade(program::bladeOf(tools));
    };
    show(); // with the tools of the site
    station.onShown(show);
    sessionPatient.follow([&](const SharedPatientModel& another) { return tools.lay(another); });
    if (entered.role == Role::Trainee)
        change.watch(window, tools);
    QObject::connect(&window, &TraineeWindow::trackerWanted, &window,
                     [&] { change.ask(window, tools); });
    QObject::connect(&window, &TraineeWindow::trackerUnwanted, &window,
                     [&] { change.take(window, tools); });
    Left left;
    QObject::connect(&window, &TraineeWindow::anotherWanted, &window, [&] {
        left.wantsAnother = true;
        window.close();
    });
    if (const QString file = program::recordOption(parser); !file.isEmpty())
        if (const auto begun = recording.begin(file); !begun)
            return tl::unexpected(begun.error());
    const auto journal = program::journalFromOptions(
        parser, station.node(), place.id(), window.stationScene(),
        [&window] { return window.notice(); },
        [&tools] {
            const auto tracking = tools.tracking();
            return tracking ? tracking->tracker().playedSince() : std::nullopt;
        });
    if (!journal)
        return tl::unexpected(journal.error());
    QObject::connect(&place, &OwnStation::changed, &place, [&](StationId now) {
        station.setStation(now);
        object.setStation(now);
        people.setStation(now);
        watch.setStation(now);
        tries.setStation(now);
        vitals.setStation(now);
        hands.setStation(now);
        sessionPatient.setStation(now);
        if (*journal)
            (*journal)->setStation(now);
    });
    shown.show(window);
    if (const auto given = program::openIgtLinkOption(parser, window, offer); !given)
        return tl::unexpected(given.error());
    left.status = showUntilClosed(window, parser, outfit.measure, station);
    finishRecording(recording);
    if (entered.role == Role::Trainee)
        outfit.tracker = tools.tracker();
    return left;
}

/// The way into another session: the person says which.
program::KnownEntry anotherEntry(const program::KnownEntry& before, const program::Entered& entered)
{
    program::KnownEntry entry{.settings = before.settings, .isAnother = true};
    entry.settings.port = 0;
    entry.settings.code.reset();
    entry.settings.station.clear();
    entry.settings.role = entered.role;
    return entry;
}

Result<int> run(const QCommandLineParser& parser)
{
    const auto options = program::measureOptions(parser);
    if (!options)
        return tl::unexpected(options.error());
    const auto output = viewOutputNamed(parser.value(QStringLiteral("output")));
    if (!output)
        return tl::unexpected(output.error());
    auto entry = entryOptions(parser, options->folder.isEmpty());
    if (!entry)
        return tl::unexpected(entry.error());
    auto outfit = outfitFrom(parser, *options, *output);
    if (!outfit)
        return tl::unexpected(outfit.error());
    ShownWindow shown;
    const auto script =
        program::scriptFromOptions(parser, [&shown]() -> QWidget& { return shown(); });
    while (true) {
        auto entered = enter(*entry, *options);
        if (!entered)
            return tl::unexpected(entered.error());
        if (!entered->node)
            return 0;
        *entry = anotherEntry(*entry, *entered);
        const auto left = takePart(parser, *outfit, *std::move(entered), shown);
        if (!left)
            return tl::unexpected(left.error());
        if (!left->wantsAnother)
            return left->status;
    }
}

} // namespace
} // namespace carina

int main(int argc, char** argv)
{
    return carina::program::runProgram({.name = QStringLiteral("carina-trainee"),
                                        .addOptions = carina::addOptions,
                                        .mostWords = 1, // a link
                                        .run = carina::run},
                                       argc, argv);
}
