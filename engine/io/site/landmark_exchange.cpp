#include "engine/io/site/landmark_exchange.h"

#include "engine/io/files/whole_file.h"
#include "engine/io/site/landmark_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace carina
{
namespace
{

struct LandmarkFormat {
    std::string_view ending;
    Result<LandmarkCatalogue> (*decode)(std::string_view text);
    std::string (*encode)(const LandmarkCatalogue& catalogue);
};

Result<LandmarkCatalogue> unnamed(Result<std::vector<Landmark>> landmarks)
{
    if (!landmarks)
        return tl::unexpected(landmarks.error());
    return LandmarkCatalogue{.name = {}, .anatomy = {}, .landmarks = std::move(*landmarks)};
}

const std::array kLandmarkFormats{
    LandmarkFormat{".csv", [](std::string_view text) { return unnamed(decodeLandmarkTable(text)); },
                   [](const LandmarkCatalogue& c) { return encodeLandmarkTable(c.landmarks); }},
    LandmarkFormat{".fcsv", [](std::string_view text) { return unnamed(decodeSlicerPoints(text)); },
                   [](const LandmarkCatalogue& c) { return encodeSlicerPoints(c.landmarks); }},
    LandmarkFormat{".mrk.json", decodeSlicerMarkups, encodeSlicerMarkups}};

Result<const LandmarkFormat*> formatOf(const std::filesystem::path& file)
{
    std::string name = file.filename().string();
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    const auto found = std::ranges::find_if(kLandmarkFormats, [&](const LandmarkFormat& format) {
        return name.ends_with(format.ending) && name.size() > format.ending.size();
    });
    if (found == kLandmarkFormats.end())
        return fail(Errc::UnknownFormat,
                    file.string() + ": landmarks are in .csv, .fcsv or .mrk.json");
    return &*found;
}

} // namespace

Result<LandmarkCatalogue> importLandmarks(const std::filesystem::path& file, std::string anatomy)
{
    const auto format = formatOf(file);
    if (!format)
        return tl::unexpected(format.error());
    const Result<std::string> bytes = readWholeFile(file, kDescriptionLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    auto catalogue = (*format)->decode(*bytes);
    if (!catalogue)
        return fail(catalogue.error().code, file.string() + ": " + catalogue.error().detail);
    const std::string name = file.filename().string();
    if (catalogue->name.empty())
        catalogue->name = name.substr(0, name.size() - (*format)->ending.size());
    catalogue->anatomy = std::move(anatomy);
    if (const auto sound = checkCatalogue(*catalogue); !sound)
        return fail(Errc::FileMalformed, file.string() + ": " + sound.error().detail);
    return catalogue;
}

Result<void> exportLandmarks(const std::filesystem::path& file, const LandmarkCatalogue& catalogue)
{
    const auto format = formatOf(file);
    if (!format)
        return tl::unexpected(format.error());
    if (const auto sound = checkCatalogue(catalogue); !sound)
        return sound;
    for (const Landmark& landmark : catalogue.landmarks)
        if (landmark.name.find_first_of("\r\n") != std::string::npos)
            return fail(Errc::OutOfRange, '"' + landmark.name + "\" is a name of several lines");
    return writeWholeFile(file, (*format)->encode(catalogue));
}

} // namespace carina
