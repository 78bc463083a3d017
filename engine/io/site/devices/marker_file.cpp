#include "engine/io/site/devices/marker_file.h"

#include "engine/io/files/json_fields.h"

namespace carina
{
namespace
{

const QString kMarkerSchema = QStringLiteral("carina.markers/1");

} // namespace

Result<MarkedBody> readMarkerFile(const std::filesystem::path& file)
{
    const auto object = readJsonFile(file, kMarkerSchema);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    fields.allowOnly({"schema", "dictionary", "markers"});
    MarkedBody body;
    body.dictionary = static_cast<MarkerDictionary>(fields.oneOf("dictionary", kDictionaryWords));
    for (JsonFields& entry : fields.objects("markers")) {
        entry.allowOnly({"id", "side_mm", "X_BK_mm"});
        body.markers.push_back({entry.count("id"), entry.length("side_mm"), entry.pose("X_BK_mm")});
    }
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    if (const auto checked = checkBody(body.markers, sizeOf(body.dictionary)); !checked)
        return fail(Errc::FileMalformed, file.string() + ": " + checked.error().detail);
    return body;
}

Result<void> writeMarkerFile(const std::filesystem::path& file, const MarkedBody& body)
{
    QJsonArray markers;
    for (const BodyMarker& marker : body.markers)
        markers.append(QJsonObject{{QStringLiteral("id"), marker.id},
                                   {QStringLiteral("side_mm"), 1e3 * marker.side},
                                   {QStringLiteral("X_BK_mm"), jsonPose(marker.X_BK)}});
    return writeJsonFile(file,
                         {{QStringLiteral("schema"), kMarkerSchema},
                          {QStringLiteral("dictionary"),
                           QString::fromLatin1(kDictionaryWords[std::size_t(body.dictionary)])},
                          {QStringLiteral("markers"), markers}});
}

} // namespace carina
