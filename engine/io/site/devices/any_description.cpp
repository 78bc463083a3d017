#include "engine/io/site/devices/any_description.h"

#include "engine/io/site/devices/plus_device_set.h"

namespace carina
{

Result<TrackerDescription> readAnyDescription(const std::filesystem::path& file)
{
    const bool isOfPlus = file.extension() == ".xml" || file.extension() == ".XML";
    return isOfPlus ? readPlusDeviceSet(file) : readTrackerFile(file);
}

} // namespace carina
