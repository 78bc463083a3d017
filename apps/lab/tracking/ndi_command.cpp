#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/core/units.h"
#include "engine/io/files/file_limit.h"
#include "engine/tracking/ndi/ndi_conversation.h"

#include <QJsonArray>

#include <map>

namespace carina::lab
{
namespace
{

constexpr const char* kDecode = "decode";

namespace ndi_key
{
constexpr Key kRecording{"recording", "FILE as given"};
constexpr Key kCommands{"commands", "that were sent"};
constexpr Key kReplies{"replies", "that came, those without a command among them"};
constexpr Key kCrcErrors{"crc_errors", "commands and replies with a wrong checksum"};
constexpr Key kPoses{"poses", "of all tools, in the replies to TX, BX and BX2"};
constexpr Key kAcceptable{lab::kAcceptable.name,
                          "false where no command and no reply has a right checksum; the exit "
                          "status is 1 then"};
constexpr Key kRefused{"refused", "one object for each command or reply that cannot be used:"};
constexpr Key kLine{"line", "of the file, where the exchange begins", 1};
constexpr Key kReason{"reason", "why it cannot be used", 1};
constexpr Key kTools{"tools", "one object for each handle of a port, in ascending order:"};
constexpr Key kHandle{"handle", "two hexadecimal digits", 1};
constexpr Key kSeen{"sights", "how often it was tracked, missing, and so on", 1};
constexpr Key kToolPoses{"poses", "one object for each pose:", 1};
constexpr Key kFrame{"frame", "number of the exposure", 2};
constexpr Key kPosition{"p_mm", "[x, y, z] in the tracker's frame", 2};
constexpr Key kRotation{"q", "[q0, qx, qy, qz], of unit length, q0 not negative", 2};
constexpr Key kError{"error_mm", "RMS of the fit to the tool's markers", 2};
constexpr Key kStatus{"status", "of the port, hexadecimal", 2};
constexpr Key kTime{"time_s", "since 1970, when the reply came; null where it is not recorded", 2};
constexpr Key kSchema{"schema", "carina.ndi/1"};
} // namespace ndi_key

const char* wordOf(NdiSight sight)
{
    switch (sight) {
    case NdiSight::Tracked:
        return "tracked";
    case NdiSight::PartlyOutOfVolume:
        return "partly_out_of_volume";
    case NdiSight::PartlyAveraged:
        return "partly_averaged";
    case NdiSight::OutOfVolume:
        return "out_of_volume";
    case NdiSight::TooFewMarkers:
        return "too_few_markers";
    case NdiSight::Interference:
        return "interference";
    case NdiSight::BadFit:
        return "bad_fit";
    case NdiSight::Missing:
        return "missing";
    case NdiSight::Disabled:
        return "disabled";
    case NdiSight::Unoccupied:
        return "unoccupied";
    case NdiSight::Failed:
        break;
    }
    return "failed";
}

QString hexadecimal(std::uint32_t number, int digits)
{
    return QStringLiteral("%1").arg(number, digits, 16, QLatin1Char{'0'}).toUpper();
}

QJsonObject poseOf(const NdiTool& tool, const std::optional<double>& seconds)
{
    const Vec3& p = tool.X_TO->translation();
    const Quat& q = tool.X_TO->rotation();
    const auto inMm = [](double length) { return inMillimetres(metres(length)); };
    return {{ndi_key::kFrame, qint64(tool.frameNumber)},
            {ndi_key::kPosition, QJsonArray{inMm(p.x()), inMm(p.y()), inMm(p.z())}},
            {ndi_key::kRotation, QJsonArray{q.w(), q.x(), q.y(), q.z()}},
            {ndi_key::kError, inMm(tool.error)},
            {ndi_key::kStatus, hexadecimal(tool.status, 8)},
            {ndi_key::kTime, seconds ? QJsonValue{*seconds} : QJsonValue{}}};
}

/// What a recording tells of one handle.
struct HandleReport {
    std::map<NdiSight, qint64> sights;
    QJsonArray poses;
};

QJsonArray toolsIn(const NdiConversation& conversation, qint64& poses)
{
    std::map<std::uint16_t, HandleReport> reports;
    for (const RecordedNdiFrame& recorded : conversation.frames)
        for (const NdiTool& tool : recorded.frame.tools) {
            HandleReport& report = reports[tool.handle];
            ++report.sights[tool.sight];
            if (tool.X_TO)
                report.poses.append(poseOf(tool, recorded.seconds));
        }
    QJsonArray tools;
    for (const auto& [handle, report] : reports) {
        QJsonObject sights;
        for (const auto& [sight, count] : report.sights)
            sights[QLatin1StringView{wordOf(sight)}] = count;
        poses += report.poses.size();
        tools.append(QJsonObject{{ndi_key::kHandle, hexadecimal(handle, 2)},
                                 {ndi_key::kSeen, sights},
                                 {ndi_key::kToolPoses, report.poses}});
    }
    return tools;
}

QJsonArray refusedIn(const NdiConversation& conversation)
{
    QJsonArray refused;
    for (const RefusedNdiReply& each : conversation.refused)
        refused.append(QJsonObject{{ndi_key::kLine, qint64(each.line)},
                                   {ndi_key::kReason, QString::fromStdString(each.error.detail)}});
    return refused;
}

Result<QJsonObject> decodeRecording(const Words& words)
{
    const QStringList files = words.files();
    if (files.size() != 2 || files[0] != QLatin1StringView{kDecode})
        return words.refuse(QStringLiteral("needs \"decode FILE\"."));
    const std::string file = files[1].toStdString();
    const auto recording = readableSize(file, kMeasurementLimit).and_then([&](std::uint64_t) {
        return readNdiRecordingFile(file);
    });
    if (!recording)
        return tl::unexpected(recording.error());
    const NdiConversation conversation = decode(*recording);
    qint64 poses = 0;
    const QJsonArray tools = toolsIn(conversation, poses);
    return QJsonObject{{ndi_key::kSchema, QLatin1StringView{ndi_key::kSchema.help}},
                       {ndi_key::kRecording, files[1]},
                       {ndi_key::kCommands, qint64(conversation.commands)},
                       {ndi_key::kReplies, qint64(conversation.replies)},
                       {ndi_key::kCrcErrors, qint64(conversation.checksumErrors)},
                       {ndi_key::kPoses, poses},
                       {ndi_key::kAcceptable,
                        conversation.checksumErrors < conversation.commands + conversation.replies},
                       {ndi_key::kRefused, refusedIn(conversation)},
                       {ndi_key::kTools, tools}};
}

} // namespace

Command ndiCommand()
{
    return {.name = "ndi",
            .theme = "tracking",
            .summary = "decodes a recorded conversation with a Polaris",
            .uses = {{.lines = {"decode FILE"},
                      .text = "Decodes the commands and replies of a recorded conversation with a "
                              "tracker of NDI: every checksum is checked, and the poses in the "
                              "replies to TX, BX and BX2 are printed.",
                      .notes = {{"FILE", "lines \"sent:0012 = TX:0001031A\" and \"recv:0012 = "
                                         "...\", or \"1127242654.21 : (INFO) 41. command[12] "
                                         "...\" with bytes that do not print as \\xHH, or the "
                                         "same without times and with the bytes as they were"}},
                      .schema = ndi_key::kSchema,
                      .keys = {ndi_key::kRecording, ndi_key::kCommands, ndi_key::kReplies,
                               ndi_key::kCrcErrors, ndi_key::kPoses, ndi_key::kAcceptable,
                               ndi_key::kRefused, ndi_key::kLine, ndi_key::kReason, ndi_key::kTools,
                               ndi_key::kHandle, ndi_key::kSeen, ndi_key::kToolPoses,
                               ndi_key::kFrame, ndi_key::kPosition, ndi_key::kRotation,
                               ndi_key::kError, ndi_key::kStatus, ndi_key::kTime}}},
            .mostFiles = 2,
            .reminder = "ndi needs \"decode FILE\".",
            .experiment = decodeRecording};
}

} // namespace carina::lab
