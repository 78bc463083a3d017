#include "engine/tracking/sequence_file.h"

#include "engine/core/units.h"
#include "engine/tracking/sequence_fields.h"
#include "engine/tracking/tool_role.h"

#include <cmath>
#include <map>
#include <string_view>

namespace carina
{

namespace
{

constexpr std::string_view kFramePrefix = "Seq_Frame";
constexpr std::string_view kTransformSuffix = "ToTrackerTransform";
constexpr std::string_view kStatusSuffix = "ToTrackerTransformStatus";
// Devices round what they report: the matrices of real recordings are up to 5e-4 off a rotation.
constexpr double kOrthonormal = 5e-3;

/// What a frame says of one tool, as text.
struct ToolText {
    std::string transform;
    std::string status;
};

/// Takes the header in line by line. Everything it keeps grows with the lines that came, never with
/// a number that a line claims.
class SequenceReader
{
public:
    explicit SequenceReader(const std::string& name) : m_name{name} {}

    Result<void> takeLine(std::string_view line);
    Result<TrackerSequence> finish();

    [[nodiscard]] bool headerEnded() const { return m_headerEnded; }

private:
    [[nodiscard]] tl::unexpected<Error> malformed(const std::string& what) const
    {
        return fail(Errc::FileMalformed, m_name + ": " + what);
    }
    [[nodiscard]] tl::unexpected<Error> badFrame(Errc code, const std::string& what) const
    {
        return fail(code, m_name + ": frame " + std::to_string(m_frames - 1) + ": " + what);
    }

    Result<void> takeFrameField(std::string_view key, std::string_view value);
    Result<void> endFrame();
    Result<SessionTime> frameTime();
    Result<void> addPose(RecordedTool& tool, const ToolText& text, SessionTime time);
    std::size_t toolIndex(const std::string& name);

    std::string m_name;
    TrackerSequence m_sequence;
    std::map<std::string, std::size_t> m_toolIndices;
    std::map<std::size_t, ToolText> m_frameTools; // of the frame being read, by tool
    std::string m_frameTime;
    std::size_t m_frames = 0; // begun
    std::optional<SessionTime> m_lastTime;
    std::optional<std::size_t> m_claimedFrames;
    bool m_headerEnded = false;
};

Result<void> SequenceReader::takeLine(std::string_view line)
{
    if (field::trimmed(line).empty())
        return {};
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
        return malformed("a line of the header has no '='");
    const std::string_view key = field::trimmed(line.substr(0, equals));
    const std::string_view value = field::trimmed(line.substr(equals + 1));
    if (key.starts_with(kFramePrefix))
        return takeFrameField(key.substr(kFramePrefix.size()), value);
    if (key == "DimSize")
        m_claimedFrames = field::numberOf<std::size_t>(field::lastWord(value));
    m_headerEnded = key == "ElementDataFile";
    return {};
}

Result<void> SequenceReader::takeFrameField(std::string_view key, std::string_view value)
{
    const std::size_t underscore = key.find('_');
    const std::optional<std::size_t> number =
        field::numberOf<std::size_t>(key.substr(0, underscore));
    if (!number || underscore == std::string_view::npos)
        return malformed("a field of a frame has no frame number");
    if (m_frames == 0 || *number != m_frames - 1) {
        if (*number != m_frames)
            return malformed("frame " + std::to_string(*number) + " comes where frame "
                             + std::to_string(m_frames) + " is expected");
        if (const Result<void> ended = endFrame(); !ended)
            return ended;
        ++m_frames;
    }
    std::string_view name = key.substr(underscore + 1);
    if (name == "Timestamp") {
        m_frameTime = value;
    } else if (name.ends_with(kTransformSuffix)) {
        name.remove_suffix(kTransformSuffix.size());
        std::string& transform = m_frameTools[toolIndex(std::string{name})].transform;
        if (!transform.empty())
            return badFrame(Errc::FileMalformed, "it has two transforms of " + std::string{name});
        transform = value;
    } else if (name.ends_with(kStatusSuffix)) {
        name.remove_suffix(kStatusSuffix.size());
        m_frameTools[toolIndex(std::string{name})].status = value;
    }
    return {};
}

Result<void> SequenceReader::endFrame()
{
    if (m_frames == 0)
        return {};
    const Result<SessionTime> time = frameTime();
    if (!time)
        return tl::unexpected{time.error()};
    for (const auto& [tool, text] : m_frameTools) {
        if (const Result<void> added = addPose(m_sequence.tools[tool], text, *time); !added)
            return added;
    }
    m_lastTime = *time;
    m_frameTools.clear();
    m_frameTime.clear();
    return {};
}

Result<SessionTime> SequenceReader::frameTime()
{
    const std::optional<double> seconds = field::numberOf<double>(m_frameTime);
    if (!seconds)
        return badFrame(Errc::FileMalformed, "its Timestamp is missing or not a number");
    if (!std::isfinite(*seconds))
        return badFrame(Errc::NotFinite, "its Timestamp is not finite");
    if (std::abs(*seconds) > field::kLongestSeconds)
        return badFrame(Errc::OutOfRange, "its Timestamp is more than a century");
    const SessionTime time{fromSeconds(*seconds)};
    if (m_lastTime && time < *m_lastTime)
        return badFrame(Errc::FileMalformed, "its Timestamp is before that of the last frame");
    return time;
}

Result<void> SequenceReader::addPose(RecordedTool& tool, const ToolText& text, SessionTime time)
{
    const std::optional<Validity> validity = field::validityOf(text.status);
    if (!validity)
        return badFrame(Errc::FileMalformed, tool.name + " has no known status");
    PoseSample sample{.time = time, .validity = *validity};
    if (*validity == Validity::Lost) {
        if (tool.samples.empty()) {
            ++tool.neverSeenYet;
            return {};
        }
        sample.X_FO = tool.samples.back().X_FO;
    } else {
        std::optional<Mat4> matrix = field::matrixOf(text.transform);
        if (!matrix)
            return badFrame(Errc::FileMalformed, tool.name + " has not the 16 numbers of a pose");
        matrix->topRightCorner<3, 1>() *= millimetres(1.0).si;
        const Result<RigidTransform> X_TO = RigidTransform::fromMatrix(*matrix, kOrthonormal);
        if (!X_TO)
            return badFrame(X_TO.error().code, tool.name + ": " + X_TO.error().detail);
        sample.X_FO = *X_TO;
    }
    tool.samples.push_back(sample);
    return {};
}

std::size_t SequenceReader::toolIndex(const std::string& name)
{
    const auto [place, isNew] = m_toolIndices.try_emplace(name, m_sequence.tools.size());
    if (isNew)
        m_sequence.tools.push_back({.name = name, .role = toolRoleOfName(name)});
    return place->second;
}

Result<TrackerSequence> SequenceReader::finish()
{
    if (!m_headerEnded)
        return malformed("it ends before the line ElementDataFile");
    if (const Result<void> ended = endFrame(); !ended)
        return tl::unexpected{ended.error()};
    if (m_claimedFrames != m_frames)
        return malformed("its DimSize does not end in the number of its frames, "
                         + std::to_string(m_frames));
    if (m_sequence.tools.empty())
        return malformed("it holds no transform to the tracker");
    return std::move(m_sequence);
}

} // namespace

Result<TrackerSequence> readSequence(std::istream& input, const std::string& name)
{
    if (input.peek() == std::istream::traits_type::eof())
        return fail(Errc::FileEmpty, name + ": it is empty");
    SequenceReader reader{name};
    for (std::string line; !reader.headerEnded() && std::getline(input, line);) {
        if (const Result<void> taken = reader.takeLine(line); !taken)
            return tl::unexpected{taken.error()};
    }
    if (input.bad())
        return fail(Errc::FileUnreadable, name + ": reading it failed");
    return reader.finish();
}

Result<TrackerSequence> readSequenceFile(const std::filesystem::path& path)
{
    return field::openFile(path).and_then(
        [&](std::ifstream input) { return readSequence(input, path.string()); });
}

} // namespace carina
