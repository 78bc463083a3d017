#include "engine/io/site/devices/camera_yaml.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace carina
{
namespace
{

constexpr std::string_view kYamlBlanks = " \t\r\n";
constexpr std::size_t kMostNumbers = 16;

/// What follows a key that begins a line; nothing where it is not there.
std::optional<std::string_view> behindKey(std::string_view text, std::string_view key)
{
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string_view::npos; ++at) {
        const bool beginsLine = at == 0 || text[at - 1] == '\n';
        const std::string_view behind = text.substr(at + key.size());
        if (beginsLine && behind.starts_with(':'))
            return behind.substr(1);
    }
    return std::nullopt;
}

/// The number at the beginning of the text, which is removed from it.
std::optional<double> takeNumber(std::string_view& text)
{
    const std::size_t begin = text.find_first_not_of(kYamlBlanks);
    if (begin == std::string_view::npos)
        return std::nullopt;
    text.remove_prefix(begin);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number))
        return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return number;
}

/// The numbers between the brackets behind "data:".
std::optional<std::vector<double>> matrixOf(std::string_view text, std::string_view key)
{
    auto behind = behindKey(text, key);
    if (!behind)
        return std::nullopt;
    constexpr std::string_view kData = "data:";
    const std::size_t data = behind->find(kData);
    if (data == std::string_view::npos)
        return std::nullopt;
    std::string_view rest = behind->substr(data + kData.size());
    const std::size_t bracket = rest.find_first_not_of(kYamlBlanks);
    if (bracket == std::string_view::npos || rest[bracket] != '[')
        return std::nullopt;
    rest.remove_prefix(bracket + 1);
    std::vector<double> numbers;
    while (numbers.size() < kMostNumbers) {
        const auto number = takeNumber(rest);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        const std::size_t next = rest.find_first_not_of(kYamlBlanks);
        if (next == std::string_view::npos)
            return std::nullopt;
        const char separator = rest[next];
        rest.remove_prefix(next + 1);
        if (separator == ']')
            return numbers;
        if (separator != ',')
            return std::nullopt;
    }
    return std::nullopt;
}

std::optional<int> countOf(std::string_view text, std::string_view key)
{
    auto behind = behindKey(text, key);
    const auto number = behind ? takeNumber(*behind) : std::nullopt;
    if (!number || *number < 1.0 || *number > 1e6 || *number != std::floor(*number))
        return std::nullopt;
    return int(*number);
}

} // namespace

Result<CameraModel> cameraFromYaml(std::string_view text)
{
    const auto lacking = [](const char* key) { return fail(Errc::FileMalformed, key); };
    const auto width = countOf(text, "image_width");
    const auto height = countOf(text, "image_height");
    if (!width || !height)
        return lacking(width ? "image_height" : "image_width");
    const auto matrix = matrixOf(text, "camera_matrix");
    if (!matrix || matrix->size() != 9)
        return lacking("camera_matrix");
    const auto distortion = matrixOf(text, "distortion_coefficients");
    if (!distortion || distortion->size() < 4)
        return lacking("distortion_coefficients");
    CameraModel camera{.width = *width,
                       .height = *height,
                       .focal = {(*matrix)[0], (*matrix)[4]},
                       .centre = {(*matrix)[2], (*matrix)[5]}};
    for (std::size_t i = 0; i < distortion->size(); ++i) {
        if (i < camera.distortion.size())
            camera.distortion[i] = (*distortion)[i];
        else if ((*distortion)[i] != 0.0)
            return lacking("distortion_coefficients: of another model than k1, k2, p1, p2, k3");
    }
    return camera;
}

} // namespace carina
