#include "models/tracker/tracker_choice.h"

#include "engine/core/expects.h"
#include "engine/io/files/unused_name.h"
#include "engine/io/site/plus_device_set.h"
#include "engine/net/devices/any_recording.h"
#include "engine/net/devices/described_tracker.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace carina
{
namespace
{

const QString kSimulated = QStringLiteral("simulated");
const QString kRecorded = QStringLiteral("recorded:");
const QString kLooped = QStringLiteral("looped:");

QString choiceWords(const char* text) { return QCoreApplication::translate("TrackerChoice", text); }

const char* nameOfKind(TrackerKind kind)
{
    switch (kind) {
    case TrackerKind::Ndi:
        break;
    case TrackerKind::OpenIgtLink:
        return QT_TRANSLATE_NOOP("TrackerChoice", "OpenIGTLink server at %1");
    case TrackerKind::Camera:
        return QT_TRANSLATE_NOOP("TrackerChoice", "Markers before the camera %1");
    }
    return QT_TRANSLATE_NOOP("TrackerChoice", "NDI tracker at %1");
}

} // namespace

Result<TrackerChoice> trackerNamed(const QString& words)
{
    if (words == kSimulated)
        return TrackerChoice{SimulatedDevice{}};
    if (words.startsWith(kRecorded))
        return recordedTracker(words.mid(kRecorded.size()).toStdString(), Playing::Once);
    if (words.startsWith(kLooped))
        return recordedTracker(words.mid(kLooped.size()).toStdString(), Playing::Looped);
    return describedIn(words.toStdString());
}

Result<TrackerChoice> describedIn(const std::filesystem::path& file)
{
    const bool isOfPlus = file.extension() == ".xml" || file.extension() == ".XML";
    return (isOfPlus ? readPlusDeviceSet(file) : readTrackerFile(file))
        .map([](TrackerDescription described) { return TrackerChoice{std::move(described)}; });
}

Result<TrackerChoice> recordedTracker(const std::string& file, Playing playing,
                                      const Progress& goesOn)
{
    return readAnyRecording(file, goesOn).map([&](TrackerSequence sequence) {
        return TrackerChoice{PlayedRecording{file, std::move(sequence), playing}};
    });
}

QString trackerName(const TrackerChoice& choice)
{
    if (const auto* recording = std::get_if<PlayedRecording>(&choice.device))
        return choiceWords(QT_TRANSLATE_NOOP("TrackerChoice", "Recording of %1"))
            .arg(QFileInfo{QString::fromStdString(recording->file)}.fileName());
    if (const auto* described = std::get_if<TrackerDescription>(&choice.device))
        return choiceWords(nameOfKind(described->kind))
            .arg(QString::fromStdString(described->address));
    return choiceWords(QT_TRANSLATE_NOOP("TrackerChoice", "Simulated tracker"));
}

QString trackerIdentity(const TrackerChoice& choice)
{
    return std::holds_alternative<PlayedRecording>(choice.device) ? QString{} : trackerName(choice);
}

KnownVolume usualVolume(const TrackerChoice& choice)
{
    if (choice.isSimulated())
        return KnownVolume::SimulatedCone;
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    return described && described->kind == TrackerKind::Ndi ? KnownVolume::PolarisPyramid
                                                            : KnownVolume::None;
}

bool hasConversation(const TrackerChoice& choice)
{
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    return described != nullptr && described->kind != TrackerKind::Camera;
}

Result<std::unique_ptr<Tracker>> makeTracker(const TrackerChoice& choice, ReadSessionClock clock)
{
    if (const auto* recording = std::get_if<PlayedRecording>(&choice.device))
        return std::make_unique<RecordedTracker>(recording->sequence, std::move(clock),
                                                 recording->playing);
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    CARINA_EXPECTS(described != nullptr);
    if (choice.conversation.empty() || !hasConversation(choice))
        return describedTracker(*described, std::move(clock));
    return DeviceLog::create(unusedName(choice.conversation), *described)
        .and_then([&](std::unique_ptr<DeviceLog> log) {
            return describedTracker(*described, std::move(clock), std::move(log));
        });
}

} // namespace carina
