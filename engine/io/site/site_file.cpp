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
    Result<QJsonObject> object = readJsonFile(file, kSiteSchema);
    if (!object && object.error().code == Errc::UnknownFormat) {
        Error other = std::move(object.error());
        object = readJsonFile(file, kFirstSiteSchema);
        if (!object)
            return tl::unexpected(std::move(other));
    }
    if (!object)
        return tl::unexpected(object.error());
    return siteIn(*object, file);
}

Result<void> writeSiteFile(const std::filesystem::path& file, const Site& site)
{
    const QJsonObject object = jsonSite(site);
    if (const Result<Site> readable = siteIn(object, file); !readable)
        return tl::unexpected(readable.error());
    return writeJsonFile(file, object);
}

} // namespace carina
