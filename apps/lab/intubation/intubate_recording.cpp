#include "apps/lab/intubation/intubate_recording.h"

#include "apps/lab/command/patient_options.h"
#include "apps/lab/intubation/intubate_page.h"
#include "apps/lab/intubation/intubation_words.h"
#include "apps/lab/intubation/recorded_intubation.h"
#include "apps/lab/intubation/trial_report.h"
#include "engine/io/site/site_file.h"
#include "engine/io/site/site_station.h"
#include "engine/net/devices/any_recording.h"
#include "engine/session/touched_blade.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr double kSmallestTube_mm = 2.5;
constexpr double kLargestTube_mm = 9.0;
constexpr double kLongestRecording_s = 36000.0;

Result<MotionCommand> commandOf(const Words& words, const QString& told)
{
    const QString step = told.section(QLatin1Char{'='}, 0, 0);
    bool isNumber = false;
    const double seconds = told.section(QLatin1Char{'='}, 1).toDouble(&isNumber);
    const auto* act = std::ranges::find(kToldActs, step, toldWord);
    if (act == kToldActs.end() || !isNumber || !(seconds >= 0.0 && seconds <= kLongestRecording_s))
        return words.refuse(
            QStringLiteral("--told %1 is not STEP=S with one of %2 and 0 to %3 seconds.")
                .arg(told, toldWords(), QString::number(kLongestRecording_s)));
    return MotionCommand{*act, fromSeconds(seconds)};
}

Result<std::vector<MotionCommand>> commandsOption(const Words& words)
{
    std::vector<MotionCommand> commands;
    for (const QString& told : words.texts(intubate_option::kTold)) {
        const auto command = commandOf(words, told);
        if (!command)
            return tl::unexpected(command.error());
        commands.push_back(*command);
    }
    std::ranges::stable_sort(commands, {}, &MotionCommand::at);
    return commands;
}

/// The blade that --blade names; nothing without it.
Result<std::optional<Blade>> bladeOption(const Words& words)
{
    if (!words.has(intubate_option::kBlade))
        return std::optional<Blade>{};
    if (const auto kind = bladeFromName(words.text(intubate_option::kBlade).toStdString()))
        return std::optional{bladeOf(*kind)};
    QStringList names;
    for (const BladeKind kind : kBladeKinds)
        names += QString::fromLatin1(bladeOf(kind).name.data());
    return words.unknownWord(intubate_option::kBlade, names);
}

std::optional<Blade> bladeByName(const TrackerSequence& recording)
{
    for (const RecordedTool& tool : recording.tools)
        if (tool.role == ToolRole::Laryngoscope)
            if (const auto kind = bladeOfTool(tool.name))
                return bladeOf(*kind);
    return std::nullopt;
}

/// Registration, tube and blade as the site has them.
Result<void> takeSite(const QString& file, const Anatomy& anatomy, RecordingSetup& setup,
                      std::optional<Blade>& blade, IntubationSubject& subject)
{
    const auto site = readSiteFile(file.toStdString());
    if (!site)
        return tl::unexpected(site.error());
    if (const auto isOf = checkPatient(*site, anatomy.name, anatomy.contentHash); !isOf)
        return isOf;
    const auto registration = stationRegistration(*site);
    if (!registration)
        return tl::unexpected(registration.error());
    setup.registration = *registration;
    const SiteTool* tube = usableTool(*site, ToolRole::Tube);
    if (tube != nullptr && tube->tube)
        takeTube(subject, anatomy,
                 tubeAlong(subject.tube, centrelineOfTube(*tube->tube), tube->tube->outerDiameter));
    const SiteTool* laryngoscope = usableTool(*site, ToolRole::Laryngoscope);
    if (laryngoscope != nullptr && laryngoscope->blade)
        blade = touchedBlade(*laryngoscope->blade);
    return {};
}

Result<IntubationSubject> subjectOf(const Words& words, const Subject& subject)
{
    return words.number(intubate_option::kTube, kSmallestTube_mm, kLargestTube_mm, 0.0)
        .and_then([&](double tube_mm) {
            return intubationSubject(subject.anatomy, subject.build, millimetres(tube_mm),
                                     words.has(intubate_option::kElastic) ? TubeBending::Elastic
                                                                          : TubeBending::Rigid);
        });
}

} // namespace

Result<IntubationSubject> intubationSubjectOption(const Words& words)
{
    return subjectOption(words).and_then(
        [&](const Subject& subject) { return subjectOf(words, subject); });
}

Result<QJsonObject> watchFile(const Words& words)
{
    const QString file = words.files().front();
    const auto named = bladeOption(words);
    if (!named)
        return tl::unexpected(named.error());
    const auto commands = commandsOption(words);
    if (!commands)
        return tl::unexpected(commands.error());
    const auto recording = readAnyRecording(file.toStdString());
    if (!recording)
        return tl::unexpected(recording.error());
    const auto who = subjectOption(words);
    if (!who)
        return tl::unexpected(who.error());
    auto subject = subjectOf(words, *who);
    if (!subject)
        return tl::unexpected(subject.error());

    RecordingSetup setup{.blade = motionBlade(subject->motion->upper), .commands = *commands};
    std::optional<Blade> known = bladeByName(*recording);
    if (words.has(intubate_option::kSite))
        if (const auto taken =
                takeSite(words.text(intubate_option::kSite), who->anatomy, setup, known, *subject);
            !taken)
            return tl::unexpected(taken.error());
    subject->isBendKnown = !subject->tube.fitsAirway && subject->lumen;
    setup.blade = named->value_or(known.value_or(setup.blade));
    return watchRecording(*subject, *recording, setup).map([&](const WatchedIntubation& watched) {
        QJsonObject report = watchedReport(*subject, watched);
        report[intubate_recording_key::kSchema] =
            QLatin1StringView{intubate_recording_key::kSchema.help};
        report[intubate_recording_key::kRecording] = file;
        report[intubate_recording_key::kBlade] =
            QString::fromLatin1(setup.blade.name.data(), qsizetype(setup.blade.name.size()));
        return report;
    });
}

} // namespace carina::lab
