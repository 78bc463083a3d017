#include "engine/tracking/record/pose_record.h"

#include "engine/core/units.h"
#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace carina
{
namespace
{

constexpr std::size_t kFramesAtOnce = 256; ///< written between two looks whether it was cancelled
constexpr std::string_view kColumns = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,error_mm,state,role,tool";
constexpr std::array<std::string_view, 3> kStates{"tracked", "partly", "lost"};
constexpr std::size_t kNumbers = 9;
constexpr double kQuaternionTolerance = 0.01;
constexpr std::size_t kMostRecordedTools = 256;
constexpr double kFarthestRecorded_mm = 1e6;

template <class... Numbers> std::string printed(const char* format, Numbers... numbers)
{
    std::array<char, 512> text{};
    const int length = std::snprintf(text.data(), text.size(), format, numbers...);
    return {text.data(), std::min(text.size() - 1, static_cast<std::size_t>(length))};
}

std::string quoted(const std::string& name)
{
    std::string text = "\"";
    for (const char c : name) {
        if (c == '"')
            text += '"';
        text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return text + '"';
}

std::optional<std::string> unquoted(std::string_view text)
{
    if (text.size() < 2 || text.front() != '"' || text.back() != '"')
        return std::nullopt;
    text = text.substr(1, text.size() - 2);
    std::string name;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"' && (++i == text.size() || text[i] != '"'))
            return std::nullopt;
        if (static_cast<unsigned char>(text[i]) < 0x20)
            return std::nullopt;
        name += text[i];
    }
    return name;
}

/// Takes what is before the next comma.
std::string_view takeField(std::string_view& text)
{
    const std::size_t comma = text.find(',');
    const std::string_view taken = text.substr(0, comma);
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    return taken;
}

class RecordReader
{
public:
    explicit RecordReader(const std::string& name) : m_name{name} {}

    Result<void> takeLine(std::string_view text)
    {
        ++m_line;
        text = field::trimmed(text);
        if (m_line == 1)
            return text == pose_record::kFirstLine
                       ? Result<void>{}
                       : refused(Errc::FileMalformed, "it does not begin with # carina.poses/1");
        if (text.empty() || text.front() == '#' || text == kColumns)
            return {};
        return takeSample(text);
    }

    Result<TrackerSequence> finish()
    {
        if (m_sequence.tools.empty())
            return fail(Errc::FileEmpty, m_name + ": it has no pose");
        return std::move(m_sequence);
    }

private:
    [[nodiscard]] tl::unexpected<Error> refused(Errc code, const char* why) const
    {
        return fail(code, m_name + ": line " + std::to_string(m_line) + ": " + why);
    }

    Result<void> takeSample(std::string_view text)
    {
        std::array<double, kNumbers> numbers{};
        for (double& number : numbers) {
            const auto value = field::numberOf<double>(takeField(text));
            if (!value)
                return refused(Errc::FileMalformed,
                               "it does not have the nine numbers of a sample");
            if (!std::isfinite(*value))
                return refused(Errc::NotFinite, "a number is not finite");
            number = *value;
        }
        if (std::any_of(numbers.begin() + 1, numbers.end(),
                        [](double number) { return std::abs(number) > kFarthestRecorded_mm; }))
            return refused(Errc::OutOfRange, "a length is more than a kilometre");
        const auto state = std::ranges::find(kStates, takeField(text));
        const auto role = toolRoleOfWord(takeField(text));
        const auto name = unquoted(text);
        if (state == kStates.end() || !role || !name)
            return refused(Errc::FileMalformed, "no state, role or name of a tool");
        const Quat q{numbers[7], numbers[4], numbers[5], numbers[6]};
        if (std::abs(q.norm() - 1.0) > kQuaternionTolerance)
            return refused(Errc::NotARotation, "the length of its quaternion is not 1");
        if (std::abs(numbers[0]) > field::kLongestSeconds)
            return refused(Errc::OutOfRange, "its time is more than a century");
        RecordedTool* tool = toolNamed(*name, *role);
        if (tool == nullptr)
            return refused(Errc::OutOfRange, "too many tools");
        const double mm = millimetres(1.0).si;
        const PoseSample sample{
            .time = SessionTime{fromSeconds(numbers[0])},
            .X_FO = {q.normalized(), mm * Vec3{numbers[1], numbers[2], numbers[3]}},
            .validity = static_cast<Validity>(state - kStates.begin()),
            .error = mm * numbers[8]};
        if (!tool->samples.empty() && sample.time < tool->samples.back().time)
            return refused(Errc::FileMalformed, "its time is before that of the sample before");
        tool->samples.push_back(sample);
        return {};
    }

    RecordedTool* toolNamed(const std::string& name, ToolRole role)
    {
        const auto [place, isNew] = m_indices.try_emplace({name, role}, m_sequence.tools.size());
        if (isNew && m_sequence.tools.size() == kMostRecordedTools)
            return nullptr;
        if (isNew)
            m_sequence.tools.push_back({.name = name, .role = role});
        return &m_sequence.tools[place->second];
    }

    std::string m_name;
    std::size_t m_line = 0;
    std::map<std::pair<std::string, ToolRole>, std::size_t> m_indices;
    TrackerSequence m_sequence;
};

/// Letters and digits only; where none is left, the word of its role.
std::string nameInSequence(const RecordedTool& tool)
{
    std::string name;
    std::ranges::copy_if(tool.name, std::back_inserter(name), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    });
    return name.empty() ? toolRoleWord(tool.role) : name;
}

/// The first name that two tools have in a sequence.
std::optional<std::string> nameOfTwo(const TrackerSequence& sequence)
{
    std::set<std::string> names;
    for (const RecordedTool& tool : sequence.tools)
        if (std::string name = nameInSequence(tool); !names.insert(name).second)
            return name;
    return std::nullopt;
}

std::string sequenceHead(std::size_t frames)
{
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
           "BinaryDataByteOrderMSB = False\nCompressedData = False\nDimSize = 0 0 "
           + std::to_string(frames) + "\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n";
}

std::string matrixText(const RigidTransform& X)
{
    Mat4 matrix = Mat4::Identity();
    matrix.topLeftCorner<3, 3>() = X.rotation().toRotationMatrix();
    matrix.topRightCorner<3, 1>() = 1e3 * X.translation();
    std::string text;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            text += printed("%s%.12g", text.empty() ? "" : " ", matrix(row, column));
    return text;
}

} // namespace

std::string pose_record::beginning()
{
    return std::string{kFirstLine} + '\n' + std::string{kColumns} + '\n';
}

std::string pose_record::line(const RecordedTool& tool, const PoseSample& sample)
{
    const Vec3 p_mm = 1e3 * sample.X_FO.translation();
    const Quat& q = sample.X_FO.rotation();
    return printed("%.9f,%.6f,%.6f,%.6f,%.9f,%.9f,%.9f,%.9f,%.6f,",
                   toSeconds(sample.time.time_since_epoch()), p_mm.x(), p_mm.y(), p_mm.z(), q.x(),
                   q.y(), q.z(), q.w(), 1e3 * sample.error)
           + std::string{kStates[static_cast<std::size_t>(sample.validity)]} + ','
           + toolRoleWord(tool.role) + ',' + quoted(tool.name) + '\n';
}

Result<TrackerSequence> pose_record::read(std::istream& input, const std::string& name)
{
    RecordReader reader{name};
    for (std::string text; std::getline(input, text);) {
        if (input.eof())
            break; // its end is missing
        if (const Result<void> taken = reader.takeLine(text); !taken)
            return tl::unexpected{taken.error()};
    }
    if (input.bad())
        return fail(Errc::FileUnreadable, name + ": reading it failed");
    return reader.finish();
}

Result<std::string> sequenceText(const TrackerSequence& sequence, const Progress& goesOn)
{
    if (const auto name = nameOfTwo(sequence))
        return fail(Errc::NameUnclear, "two tools are called " + *name
                                           + " in a sequence; in .csv and .tum they are kept "
                                             "apart");
    std::map<SessionTime, std::vector<std::pair<const RecordedTool*, const PoseSample*>>> frames;
    for (const RecordedTool& tool : sequence.tools)
        for (const PoseSample& sample : tool.samples)
            frames[sample.time].push_back({&tool, &sample});
    std::string text = sequenceHead(frames.size());
    std::size_t number = 0;
    for (const auto& [time, tools] : frames) {
        if (goesOn && number % kFramesAtOnce == 0
            && !goesOn(double(number) / double(frames.size())))
            return fail(Errc::Cancelled, "a sequence");
        const std::string frame = printed("Seq_Frame%04zu_", number++);
        for (const auto& [tool, sample] : tools) {
            const std::string transform = frame + nameInSequence(*tool) + "ToTrackerTransform";
            text += transform + " = " + matrixText(sample->X_FO) + '\n' + transform
                    + "Status = " + (sample->validity == Validity::Lost ? "MISSING" : "OK") + '\n';
        }
        text += frame + printed("Timestamp = %.9f\n", toSeconds(time.time_since_epoch()));
    }
    return text + "ElementDataFile = LOCAL\n";
}

std::string tumText(const RecordedTool& tool)
{
    std::string text;
    for (const PoseSample& sample : tool.samples) {
        if (sample.validity == Validity::Lost)
            continue;
        const Vec3& p = sample.X_FO.translation();
        const Quat& q = sample.X_FO.rotation();
        text += printed("%.9f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n",
                        toSeconds(sample.time.time_since_epoch()), p.x(), p.y(), p.z(), q.x(),
                        q.y(), q.z(), q.w());
    }
    return text;
}

} // namespace carina
