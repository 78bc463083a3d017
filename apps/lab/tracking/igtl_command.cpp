#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"
#include "engine/tracking/igtl/igtl_pose.h"
#include "engine/tracking/igtl/igtl_reader.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

constexpr const char* kDecodeIgtl = "decode";
constexpr std::size_t kMostKeptOfFile = 64U << 20U;

namespace igtl_key
{
constexpr Key kFile{"file", "FILE as given"};
constexpr Key kMessages{"messages", "one object for each message that is read or passed over:"};
constexpr Key kType{"type", "such as TRANSFORM", 1};
constexpr Key kDevice{"device", "the name of its sender or tool", 1};
constexpr Key kVersion{"version", "of its header", 1};
constexpr Key kTime{"time_s", "since 1970; null where it states none", 1};
constexpr Key kMetadata{"metadata", "its words and their values", 1};
constexpr Key kPoses{"poses", "one object for each pose that it has:", 1};
constexpr Key kName{"name", "of the tool", 2};
constexpr Key kPosition{"p_mm", "[x, y, z]", 2};
constexpr Key kRotation{"q", "[q0, qx, qy, qz], of unit length, q0 not negative", 2};
constexpr Key kFault{"fault", "in the place of both: why it is no pose", 2};
constexpr Key kText{"text", "of STRING and STATUS", 1};
constexpr Key kCode{"code", "of STATUS; 1 means OK", 1};
constexpr Key kPoints{"points", "of POLYDATA and POINT", 1};
constexpr Key kPolygons{"polygons", "of POLYDATA", 1};
constexpr Key kSkipped{"skipped", "true for a type that is not read", 1};
constexpr Key kReencoded{"reencodes", "whether encoding it gives the same bytes", 1};
constexpr Key kAcceptable{
    lab::kAcceptable.name,
    "false where no message is read or passed over; the exit status is 1 then"};
constexpr Key kRefused{"refused", "the reason of each message that is refused, in their order"};
constexpr Key kSchema{"schema", "carina.igtl/1"};
} // namespace igtl_key

QJsonObject poseJson(const std::string& name, const Result<RigidTransform>& pose)
{
    QJsonObject object{{igtl_key::kName, QString::fromStdString(name)}};
    if (!pose) {
        object[igtl_key::kFault] = QString::fromStdString(pose.error().detail);
        return object;
    }
    const Vec3 p_mm = pose->translation() * inMillimetres(metres(1.0));
    const Quat& q = pose->rotation();
    object[igtl_key::kPosition] = QJsonArray{p_mm.x(), p_mm.y(), p_mm.z()};
    object[igtl_key::kRotation] = QJsonArray{q.w(), q.x(), q.y(), q.z()};
    return object;
}

QJsonArray posesIn(const IgtlMessage& message)
{
    QJsonArray poses;
    if (const auto* transform = std::get_if<IgtlTransform>(&message.content))
        poses.append(poseJson(message.device, poseOf(transform->matrix)));
    if (const auto* position = std::get_if<IgtlPosition>(&message.content))
        poses.append(poseJson(message.device, poseOf(*position)));
    if (const auto* tdata = std::get_if<IgtlTrackingData>(&message.content))
        for (const IgtlTracked& tool : tdata->tools)
            poses.append(poseJson(tool.name, poseOf(tool.matrix)));
    if (const auto* qtdata = std::get_if<IgtlQuaternionTrackingData>(&message.content))
        for (const IgtlQuaternionTracked& tool : qtdata->tools)
            poses.append(poseJson(tool.name, poseOf(tool)));
    return poses;
}

/// The keys that only some types have.
void addContent(QJsonObject& object, const IgtlMessage& message)
{
    if (const QJsonArray poses = posesIn(message); !poses.isEmpty())
        object[igtl_key::kPoses] = poses;
    if (const auto* string = std::get_if<IgtlString>(&message.content))
        object[igtl_key::kText] = QString::fromStdString(string->text);
    if (const auto* status = std::get_if<IgtlStatus>(&message.content)) {
        object[igtl_key::kCode] = status->code;
        object[igtl_key::kText] = QString::fromStdString(status->text);
    }
    if (const auto* points = std::get_if<IgtlPoints>(&message.content))
        object[igtl_key::kPoints] = qint64(points->points.size());
    if (const auto* surface = std::get_if<IgtlPolyData>(&message.content)) {
        object[igtl_key::kPoints] = qint64(surface->points.size());
        object[igtl_key::kPolygons] = qint64(surface->cells[kIgtlPolygons].count);
    }
}

QJsonObject messageJson(const IgtlMessage& message, std::span<const std::byte> bytes)
{
    QJsonObject object{{igtl_key::kType, QString::fromStdString(typeOf(message.content))},
                       {igtl_key::kDevice, QString::fromStdString(message.device)},
                       {igtl_key::kVersion, message.version},
                       {igtl_key::kTime, message.stamp == 0
                                             ? QJsonValue{}
                                             : QJsonValue{toSeconds(sinceEpoch(message.stamp))}}};
    if (!message.metadata.empty()) {
        QJsonObject metadata;
        for (const IgtlMetadata& entry : message.metadata)
            metadata[QString::fromStdString(entry.key)] = QString::fromStdString(entry.value);
        object[igtl_key::kMetadata] = metadata;
    }
    addContent(object, message);
    if (std::holds_alternative<IgtlSkipped>(message.content))
        object[igtl_key::kSkipped] = true;
    else
        object[igtl_key::kReencoded] = std::ranges::equal(encodeIgtl(message), bytes);
    return object;
}

/// All messages of a stream, each with its bytes.
QJsonObject decoded(std::span<const std::byte> stream)
{
    QJsonArray messages;
    QJsonArray refused;
    IgtlReader reader{kMostKeptOfFile};
    const auto refuse = [&](const std::string& why) {
        refused.append(QString::fromStdString(why));
    };
    std::size_t begin = 0;
    while (begin < stream.size() && !reader.isLost()) {
        const auto rest = stream.subspan(begin);
        std::size_t length = rest.size();
        if (rest.size() >= IgtlHeader::kBytes)
            if (const auto header = IgtlHeader::read(rest.first(IgtlHeader::kBytes)))
                length = std::min<std::uint64_t>(length, IgtlHeader::kBytes + header->bodyBytes);
        reader.take(rest.first(length));
        if (const auto message = reader.next(); message && *message)
            messages.append(messageJson(**message, rest.first(length)));
        else if (message)
            refuse(message->error().detail);
        begin += length;
    }
    if (reader.isWithin())
        refuse("the end of the last message is missing");
    return {{igtl_key::kMessages, messages},
            {igtl_key::kRefused, refused},
            {igtl_key::kAcceptable, !messages.isEmpty()}};
}

Result<QJsonObject> decodeFile(const Words& words)
{
    const QStringList files = words.files();
    if (files.size() != 2 || files[0] != QLatin1StringView{kDecodeIgtl})
        return words.refuse(QStringLiteral("needs \"decode FILE\"."));
    const auto bytes = readWholeFile(files[1].toStdString(), kMeasurementLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    QJsonObject object = decoded(std::as_bytes(std::span{*bytes}));
    object[igtl_key::kSchema] = QLatin1StringView{igtl_key::kSchema.help};
    object[igtl_key::kFile] = files[1];
    return object;
}

} // namespace

Command igtlCommand()
{
    return {.name = "igtl",
            .theme = "tracking",
            .summary = "decodes messages of OpenIGTLink",
            .uses = {{.lines = {"decode FILE"},
                      .text = "Decodes the messages of OpenIGTLink in a file, one behind the other "
                              "as they travel: headers of version 1 and 2, every checksum is "
                              "checked.",
                      .notes = {{"FILE", "the bytes of a connection, or of one message"}},
                      .schema = igtl_key::kSchema,
                      .keys = {igtl_key::kFile,     igtl_key::kMessages,  igtl_key::kType,
                               igtl_key::kDevice,   igtl_key::kVersion,   igtl_key::kTime,
                               igtl_key::kMetadata, igtl_key::kPoses,     igtl_key::kName,
                               igtl_key::kPosition, igtl_key::kRotation,  igtl_key::kFault,
                               igtl_key::kText,     igtl_key::kCode,      igtl_key::kPoints,
                               igtl_key::kPolygons, igtl_key::kSkipped,   igtl_key::kReencoded,
                               igtl_key::kRefused,  igtl_key::kAcceptable}}},
            .mostFiles = 2,
            .reminder = "igtl needs \"decode FILE\".",
            .experiment = decodeFile};
}

} // namespace carina::lab
