// Any bytes as a site file: refused with a reason, or read as a site that is written and read
// again. The digest, which nobody finds by trying, is left out.

#include "engine/core/expects.h"
#include "engine/io/site/site_file.h"
#include "engine/io/site/site_json.h"
#include "tests/fuzz/file_of_input.h"

namespace
{

using namespace carina;

/// As a whole file, of a version that needs no digest where it has none.
void readFile(const std::uint8_t* data, std::size_t size)
{
    static const fuzz::OwnFolder folder;
    const auto site = readSiteFile(folder.holding("site.json", data, size));
    CARINA_EXPECTS(site || !site.error().detail.empty());
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    readFile(data, size);
    auto object = jsonObjectIn({reinterpret_cast<const char*>(data), size});
    if (!object)
        return 0;
    object->remove(QStringLiteral("digest"));
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    const Site site = readSite(fields);
    if (fault) {
        CARINA_EXPECTS(!fault->detail.empty());
        return 0;
    }
    JsonFields again{jsonSite(site), fault};
    const Site same = readSite(again);
    CARINA_EXPECTS(!fault && jsonSite(same).keys() == jsonSite(site).keys());
    return 0;
}
