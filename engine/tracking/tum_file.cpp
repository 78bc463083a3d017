#include "engine/tracking/tum_file.h"

#include "engine/core/units.h"
#include "engine/tracking/sequence_fields.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace carina
{
namespace
{

constexpr double kQuaternionLength = 0.01; // files are rounded to a few digits

using Row = std::array<double, 8>;

std::optional<Row> rowOf(std::string_view text)
{
    Row row{};
    for (double& number : row) {
        text = field::trimmed(text);
        const std::string_view word = text.substr(0, text.find_first_of(" \t\r"));
        const std::optional<double> value = field::numberOf<double>(word);
        if (!value)
            return std::nullopt;
        number = *value;
        text.remove_prefix(word.size());
    }
    if (!field::trimmed(text).empty())
        return std::nullopt;
    return row;
}

class TumReader
{
public:
    explicit TumReader(const std::string& name) : m_name{name} {}

    Result<void> takeLine(std::string_view line)
    {
        ++m_line;
        line = field::trimmed(line);
        if (line.empty() || line.starts_with('#'))
            return {};
        const std::optional<Row> row = rowOf(line);
        if (!row)
            return refused(Errc::FileMalformed, "it does not have the eight numbers of a pose");
        return takeRow(*row);
    }

    Result<std::vector<PoseSample>> finish()
    {
        if (m_samples.empty())
            return fail(Errc::FileEmpty, m_name + ": it has no pose");
        return std::move(m_samples);
    }

private:
    [[nodiscard]] tl::unexpected<Error> refused(Errc code, const std::string& what) const
    {
        return fail(code, m_name + ": line " + std::to_string(m_line) + ": " + what);
    }

    Result<void> takeRow(const Row& row)
    {
        for (const double number : row) {
            if (!std::isfinite(number))
                return refused(Errc::NotFinite, "a number is not finite");
        }
        const double start = m_start.value_or(row[0]);
        if (std::abs(row[0] - start) > field::kLongestSeconds)
            return refused(Errc::OutOfRange, "its time is more than a century from the first");
        const SessionTime time{fromSeconds(row[0] - start)};
        if (!m_samples.empty() && time < m_samples.back().time)
            return refused(Errc::FileMalformed, "its time is before that of the pose before");
        const Quat q_FO{row[7], row[4], row[5], row[6]};
        if (std::abs(q_FO.norm() - 1.0) > kQuaternionLength)
            return refused(Errc::NotARotation, "the length of its quaternion is not 1");
        m_start = start;
        if (m_samples.empty() || time > m_samples.back().time)
            m_samples.push_back(
                {.time = time, .X_FO = {q_FO.normalized(), Vec3{row[1], row[2], row[3]}}});
        return {};
    }

    std::string m_name;
    std::size_t m_line = 0;
    std::optional<double> m_start;
    std::vector<PoseSample> m_samples;
};

} // namespace

Result<std::vector<PoseSample>> readTum(std::istream& input, const std::string& name)
{
    TumReader reader{name};
    for (std::string line; std::getline(input, line);) {
        if (const Result<void> taken = reader.takeLine(line); !taken)
            return tl::unexpected{taken.error()};
    }
    if (input.bad())
        return fail(Errc::FileUnreadable, name + ": reading it failed");
    return reader.finish();
}

Result<std::vector<PoseSample>> readTumFile(const std::filesystem::path& path)
{
    return field::openFile(path).and_then(
        [&](std::ifstream input) { return readTum(input, path.string()); });
}

} // namespace carina
