#include "engine/io/site/site_file.h"

#include "engine/io/site/site_json.h"

namespace carina
{
namespace
{

Result<Site> siteIn(const QJsonObject& object, const std::filesystem::path& file)
{
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
    const QJsonObject object = jsonSite(site);
    if (const Result<Site> readable = siteIn(object, file); !readable)
        return tl::unexpected(readable.error());
    return writeJsonFile(file, object);
}

} // namespace carina
