#include "engine/io/site/site_file.h"

#include "engine/io/files/check_digest.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/site_json.h"

#include <QJsonDocument>

#include <algorithm>

namespace carina
{
namespace
{

const QString kDigest = QStringLiteral("digest");

/// Of an object as it is read: its fields in the order of their names, without blanks.
QString digestOf(const QJsonObject& object)
{
    return QString::fromLatin1(
        checkDigest(QJsonDocument{object}.toJson(QJsonDocument::Compact)).toHex());
}

/// What a reader gets of an object, with its digest.
QJsonObject withDigest(const QJsonObject& object)
{
    QJsonObject read = QJsonDocument::fromJson(QJsonDocument{object}.toJson()).object();
    read.insert(kDigest, digestOf(read));
    return read;
}

Result<Site> siteIn(QJsonObject object, const std::filesystem::path& file)
{
    const QJsonValue schema = object.value(QStringLiteral("schema"));
    const bool needsDigest =
        schema == kSiteSchema
        || std::ranges::count(kEarlierSchemasWithDigest, schema.toString()) > 0;
    const QJsonValue digest = object.take(kDigest);
    if ((needsDigest || !digest.isUndefined()) && digest != QJsonValue{digestOf(object)})
        return fail(Errc::FileMalformed, file.string() + ": its content does not match its digest");
    std::optional<Error> fault;
    JsonFields fields{object, fault};
    Site site = readSite(fields);
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    return site;
}

} // namespace

Result<Site> readSiteFile(const std::filesystem::path& file)
{
    const Result<QJsonObject> object = readJsonFile(file, kSiteSchema);
    if (object)
        return siteIn(*object, file);
    if (object.error().code == Errc::UnknownFormat)
        for (const QString& schema : kEarlierSiteSchemas)
            if (const auto earlier = readJsonFile(file, schema))
                return siteIn(*earlier, file);
    return tl::unexpected(object.error());
}

Result<void> writeSiteFile(const std::filesystem::path& file, const Site& site)
{
    const QJsonObject object = withDigest(jsonSite(site));
    if (const Result<Site> readable = siteIn(object, file); !readable)
        return tl::unexpected(readable.error());
    return writePrivateFile(file, QJsonDocument{object}.toJson().toStdString());
}

} // namespace carina
