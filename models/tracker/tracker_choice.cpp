#include "models/tracker/tracker_choice.h"

#include "engine/core/expects.h"
#include "engine/io/files/unused_name.h"
#include "engine/io/site/devices/any_description.h"
#include "engine/io/site/site_file.h"
#include "engine/net/devices/any_recording.h"
#include "engine/net/devices/described_tracker.h"
#include "engine/tracking/several/tracker_set.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDataStream>
#include <QFileInfo>
#include <QStringList>

#include <algorithm>

namespace carina
{
namespace
{

const QString kSimulated = QStringLiteral("simulated");
const QString kSimulatedWith = QStringLiteral("simulated:");
const QString kRecorded = QStringLiteral("recorded:");
const QString kLooped = QStringLiteral("looped:");
constexpr qsizetype kDigits = 8; // that tell what a tracker rests on

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

QString nameOf(const TrackerDescription& described)
{
    return choiceWords(nameOfKind(described.kind)).arg(QString::fromStdString(described.address));
}

QDataStream& operator<<(QDataStream& stream, const CameraModel& camera)
{
    stream << camera.width << camera.height << camera.focal.x() << camera.focal.y()
           << camera.centre.x() << camera.centre.y();
    for (const double each : camera.distortion)
        stream << each;
    return stream;
}

QDataStream& operator<<(QDataStream& stream, const MarkedBody& body)
{
    stream << int(body.dictionary);
    for (const BodyMarker& marker : body.markers) {
        stream << marker.id << marker.side;
        const Mat4 X_BK = marker.X_BK.matrix();
        for (const double each : X_BK.reshaped())
            stream << each;
    }
    return stream;
}

void writeDefinition(QDataStream& stream, const NdiToolDefinition& definition)
{
    stream.writeRawData(reinterpret_cast<const char*>(definition.bytes().data()),
                        int(definition.bytes().size()));
}

/// What the poses of a device's tools rest on; empty where none of it is known.
QByteArray groundsOf(const TrackerDescription& described)
{
    QByteArray grounds;
    QDataStream stream{&grounds, QIODevice::WriteOnly};
    if (described.kind == TrackerKind::Camera)
        stream << described.camera;
    for (const ToolRole role : {ToolRole::Stylus, ToolRole::Jaw, ToolRole::Manikin, ToolRole::Tube,
                                ToolRole::Laryngoscope})
        for (const DescribedTool& tool : described.tools) {
            const bool isKnown = tool.role == role && (tool.definition || tool.body);
            if (isKnown)
                stream << int(role);
            if (isKnown && tool.definition)
                writeDefinition(stream, *tool.definition);
            if (isKnown && tool.body)
                stream << *tool.body;
        }
    return grounds;
}

bool hasConversation(const TrackerDescription& described)
{
    return described.kind != TrackerKind::Camera;
}

/// The device that is asked where one stands for all.
const TrackerDescription* firstDevice(const TrackerChoice& choice)
{
    if (const auto* set = std::get_if<DeviceSet>(&choice.device))
        return &set->devices.front().described;
    return std::get_if<TrackerDescription>(&choice.device);
}

/// The same of all devices.
QByteArray groundsOf(const TrackerChoice& choice)
{
    if (const auto* described = std::get_if<TrackerDescription>(&choice.device))
        return groundsOf(*described);
    QByteArray grounds;
    if (const auto* set = std::get_if<DeviceSet>(&choice.device))
        for (const PlacedDescription& device : set->devices)
            grounds += groundsOf(device.described);
    return grounds;
}

/// @param conversation of TrackerChoice
Result<std::unique_ptr<Tracker>> makeDevice(const TrackerDescription& described,
                                            const std::string& conversation, ReadSessionClock clock)
{
    if (conversation.empty() || !hasConversation(described))
        return describedTracker(described, std::move(clock));
    return DeviceLog::create(unusedName(conversation), described)
        .and_then([&](std::unique_ptr<DeviceLog> log) {
            return describedTracker(described, std::move(clock), std::move(log));
        });
}

Result<std::unique_ptr<Tracker>> makeSet(const DeviceSet& set, const std::string& conversation,
                                         const ReadSessionClock& clock)
{
    std::vector<PlacedTracker> placed;
    for (const PlacedDescription& device : set.devices) {
        auto made = makeDevice(device.described, conversation, clock);
        if (!made)
            return made;
        placed.push_back({*std::move(made), device.place});
    }
    return std::make_unique<TrackerSet>(std::move(placed));
}

} // namespace

Result<TrackerChoice> trackerNamed(const QString& words, const Progress& goesOn)
{
    if (words == kSimulated)
        return TrackerChoice{SimulatedDevice{}};
    if (words.startsWith(kSimulatedWith))
        return readSimulatedOptions(words.mid(kSimulatedWith.size()).toStdString())
            .map([](SimulatedTrackerSettings settings) {
                return TrackerChoice{SimulatedDevice{std::move(settings)}};
            });
    if (words.startsWith(kRecorded))
        return recordedTracker(words.mid(kRecorded.size()).toStdString(), Playing::Once, goesOn);
    if (words.startsWith(kLooped))
        return recordedTracker(words.mid(kLooped.size()).toStdString(), Playing::Looped, goesOn);
    return describedIn(words.toStdString());
}

QString simulatedName(const SimulatedOptions& options)
{
    const QString words = QString::fromStdString(simulatedWords(options));
    return words.isEmpty() ? kSimulated : kSimulatedWith + words;
}

Result<TrackerChoice> describedIn(const std::filesystem::path& file)
{
    return readAnyDescription(file).map(
        [](TrackerDescription described) { return TrackerChoice{std::move(described)}; });
}

Result<std::optional<TrackerChoice>> trackerOfSite(const std::filesystem::path& site)
{
    const auto read = readSiteFile(site);
    if (!read && read.error().code == Errc::FileNotFound)
        return std::nullopt;
    if (!read)
        return tl::unexpected(read.error());
    return readSiteDevices(site.parent_path(), read->devices)
        .map([](std::vector<PlacedDescription> placed) -> std::optional<TrackerChoice> {
            if (placed.empty())
                return std::nullopt;
            if (placed.size() == 1)
                return TrackerChoice{std::move(placed.front().described)};
            return TrackerChoice{DeviceSet{std::move(placed)}};
        });
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
        return nameOf(*described);
    if (const auto* set = std::get_if<DeviceSet>(&choice.device)) {
        QStringList names;
        for (const PlacedDescription& device : set->devices)
            names += nameOf(device.described);
        return names.join(QStringLiteral(" + "));
    }
    return choiceWords(QT_TRANSLATE_NOOP("TrackerChoice", "Simulated tracker"));
}

QString trackerIdentity(const TrackerChoice& choice)
{
    if (std::holds_alternative<PlayedRecording>(choice.device))
        return {};
    const TrackerDescription* device = firstDevice(choice);
    if (device == nullptr)
        return trackerName(choice);
    const QByteArray grounds = groundsOf(choice);
    if (grounds.isEmpty())
        return nameOf(*device);
    const QByteArray digest = QCryptographicHash::hash(grounds, QCryptographicHash::Sha256);
    return QStringLiteral("%1 (%2)").arg(nameOf(*device),
                                         QString::fromLatin1(digest.toHex().first(kDigits)));
}

std::vector<PlacedDescription> devicesOf(const TrackerChoice& choice)
{
    if (const auto* set = std::get_if<DeviceSet>(&choice.device))
        return set->devices;
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    return described ? std::vector{PlacedDescription{*described, {}}}
                     : std::vector<PlacedDescription>{};
}

QByteArray contentOf(const TrackerDescription& described)
{
    QByteArray content;
    QDataStream stream{&content, QIODevice::WriteOnly};
    stream << int(described.kind) << QByteArray::fromStdString(described.address)
           << int(described.poses) << described.fastestRate << int(described.igtlPoses)
           << described.rate_hz << described.isLooped << described.camera;
    for (const DescribedTool& tool : described.tools) {
        stream << int(tool.role) << QByteArray::fromStdString(tool.name)
               << QByteArray::fromStdString(tool.device) << tool.definition.has_value()
               << int(tool.body ? tool.body->markers.size() : 0);
        if (tool.definition)
            writeDefinition(stream, *tool.definition);
        if (tool.body)
            stream << *tool.body;
    }
    return content;
}

bool areSameDevices(const std::optional<TrackerChoice>& a, const std::optional<TrackerChoice>& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    const auto all = devicesOf(*a);
    const auto others = devicesOf(*b);
    return !all.empty()
           && std::ranges::equal(
               all, others, [](const PlacedDescription& one, const PlacedDescription& other) {
                   return one.place == other.place
                          && contentOf(one.described) == contentOf(other.described);
               });
}

KnownVolume usualVolume(const TrackerChoice& choice)
{
    if (choice.isSimulated())
        return KnownVolume::SimulatedCone;
    const TrackerDescription* device = firstDevice(choice);
    return device != nullptr && device->kind == TrackerKind::Ndi ? KnownVolume::PolarisPyramid
                                                                 : KnownVolume::None;
}

bool hasConversation(const TrackerChoice& choice)
{
    if (const auto* set = std::get_if<DeviceSet>(&choice.device))
        return std::ranges::any_of(set->devices, [](const PlacedDescription& device) {
            return hasConversation(device.described);
        });
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    return described != nullptr && hasConversation(*described);
}

Result<std::unique_ptr<Tracker>> makeTracker(const TrackerChoice& choice, ReadSessionClock clock)
{
    if (const auto* recording = std::get_if<PlayedRecording>(&choice.device))
        return std::make_unique<RecordedTracker>(recording->sequence, std::move(clock),
                                                 recording->playing);
    if (const auto* set = std::get_if<DeviceSet>(&choice.device))
        return makeSet(*set, choice.conversation, clock);
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    CARINA_EXPECTS(described != nullptr);
    return makeDevice(*described, choice.conversation, std::move(clock));
}

} // namespace carina
