#include "evaluation/waveforms/recorded_waveform.h"

#include "engine/io/files/file_limit.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace carina
{
namespace
{

std::string waveformLine(const std::string& file, qsizetype line)
{
    return file + " line " + std::to_string(line + 1);
}

Result<double> waveformNumber(const QByteArray& field, const std::string& place)
{
    bool isNumber = false;
    const double number = field.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number))
        return fail(Errc::FileMalformed,
                    place + ": \"" + field.toStdString() + "\" is not a number.");
    return number;
}

std::size_t switchSamples(const RecordedWaveform& waveform)
{
    return std::max<std::size_t>(1, std::size_t(kSwitchTime * waveform.rate_hz + 0.5));
}

Result<void> addSample(const QByteArray& pressure, const QByteArray& flow, const std::string& place,
                       RecordedWaveform& waveform)
{
    const auto p = waveformNumber(pressure, place);
    if (!p)
        return tl::unexpected(p.error());
    waveform.pressure_cmH2O.push_back(*p);
    if (flow.isEmpty())
        return {};
    const auto q = waveformNumber(flow, place);
    if (!q)
        return tl::unexpected(q.error());
    waveform.flow_lPerS.push_back(*q / 60.0);
    return {};
}

/// Median; the values are reordered.
double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// One past the last sample from `from` on that has the part of `from`.
std::size_t endOfPart(const std::vector<BreathPart>& parts, std::size_t from)
{
    const auto begin = parts.begin() + std::ptrdiff_t(from);
    const BreathPart part = *begin;
    const auto end = std::find_if(begin, parts.end(), [part](BreathPart p) { return p != part; });
    return std::size_t(end - parts.begin());
}

/// The lowest median of five neighbours: the end of an expiration without its noise.
double lowestOf(std::span<const double> pressures)
{
    constexpr std::size_t kNeighbours = 5;
    if (pressures.size() < kNeighbours)
        return *std::min_element(pressures.begin(), pressures.end());
    double lowest = pressures.front();
    for (std::size_t i = 0; i + kNeighbours <= pressures.size(); ++i)
        lowest = std::min(lowest, medianOf({pressures.begin() + std::ptrdiff_t(i),
                                            pressures.begin() + std::ptrdiff_t(i + kNeighbours)}));
    return lowest;
}

/// The sample after the steepest rise, or fall.
std::size_t steepestStep(std::span<const double> pressures, bool rises)
{
    std::size_t steepest = 1;
    const auto step = [&](std::size_t i) {
        return (rises ? 1.0 : -1.0) * (pressures[i] - pressures[i - 1]);
    };
    for (std::size_t i = 2; i < pressures.size(); ++i) {
        if (step(i) > step(steepest))
            steepest = i;
    }
    return steepest;
}

std::span<const double> samplesOf(const RecordedWaveform& waveform, std::size_t from,
                                  std::size_t to)
{
    return std::span{waveform.pressure_cmH2O}.subspan(from, to - from);
}

/// Marks moments of an open tube with kSwitchTime after them, and what lies between two that follow
/// within kReconnection.
void markOpenTube(const RecordedWaveform& waveform, std::vector<BreathPart>& parts)
{
    std::vector<double> ends;
    for (std::size_t i = 0; i < parts.size(); i = endOfPart(parts, i)) {
        const std::size_t end = endOfPart(parts, i);
        if (parts[i] == BreathPart::Expiration)
            ends.push_back(lowestOf(samplesOf(waveform, i, end)));
    }
    if (ends.empty())
        return;
    const double open = kOpenShare * medianOf(std::move(ends));
    const auto bridged = std::size_t(kReconnection * waveform.rate_hz);
    const std::size_t after = switchSamples(waveform);
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (waveform.pressure_cmH2O[i] >= open)
            continue;
        const std::size_t from = last && i - *last <= bridged ? *last : i;
        const std::size_t to = std::min(parts.size(), i + 1 + after);
        std::fill(parts.begin() + std::ptrdiff_t(from), parts.begin() + std::ptrdiff_t(to),
                  BreathPart::Disconnected);
        last = i;
    }
}

} // namespace

Result<RecordedWaveform> readWaveform(const QString& file)
{
    const std::string name = file.toStdString();
    if (const auto good = readableSize(name, kMeasurementLimit); !good)
        return tl::unexpected(good.error());
    QFile source{file};
    if (!source.open(QIODevice::ReadOnly))
        return fail(Errc::FileNotFound, name + " cannot be opened.");
    const QList<QByteArray> lines = source.readAll().split('\n');
    const QList<QByteArray> first = lines.front().trimmed().split(',');
    const QList<QByteArray> header = lines.value(1).trimmed().split(',');
    const qsizetype pressure = header.indexOf("pressure");
    const qsizetype flow = header.indexOf("flow");
    if (first.size() < 2 || first[0] != "#samplerate" || pressure < 0 || flow < 0)
        return fail(Errc::FileMalformed,
                    name + " has not the lines \"#samplerate,HZ\" and \"pressure,flow\".");
    RecordedWaveform waveform;
    const Result<double> rate = waveformNumber(first[1], waveformLine(name, 0));
    if (!rate || *rate < 10.0)
        return fail(Errc::FileMalformed, name + " has a sample rate below 10 Hz.");
    waveform.rate_hz = *rate;
    for (qsizetype line = 2; line < lines.size(); ++line) {
        const QList<QByteArray> fields = lines[line].trimmed().split(',');
        if (fields.size() == 1 && fields[0].isEmpty())
            continue;
        const Result<void> added = addSample(fields.value(pressure), fields.value(flow),
                                             waveformLine(name, line), waveform);
        if (!added)
            return tl::unexpected(added.error());
    }
    const std::size_t flows = waveform.flow_lPerS.size();
    if (flows != 0 && flows != waveform.pressure_cmH2O.size())
        return fail(Errc::FileMalformed, name + " has a flow in some lines only.");
    if (waveform.pressure_cmH2O.empty())
        return fail(Errc::FileMalformed, name + " has no samples.");
    return waveform;
}

std::vector<BreathPart> breathParts(const RecordedWaveform& waveform)
{
    const std::vector<double>& p = waveform.pressure_cmH2O;
    std::vector<BreathPart> parts(p.size(), BreathPart::Expiration);
    const std::size_t ahead = switchSamples(waveform);
    const auto [least, most] = std::ranges::minmax(p);
    BreathPart now = BreathPart::Expiration;
    std::size_t from = 0; // of the part that is going on
    for (std::size_t i = 0; i + ahead < p.size(); ++i) {
        const double rise = p[i + ahead] - p[i];
        const double height = (p[i] - least) / (most - least);
        const bool begins =
            now == BreathPart::Expiration && rise > kSwitchRise && height < kRisesBelow;
        const bool ends =
            now == BreathPart::Inspiration && rise < -kSwitchRise && height > kFallsAbove;
        if (!begins && !ends)
            continue;
        const std::size_t at = steepestStep(std::span{p}.subspan(i, ahead + 1), begins) + i;
        std::fill(parts.begin() + std::ptrdiff_t(from), parts.begin() + std::ptrdiff_t(at), now);
        now = begins ? BreathPart::Inspiration : BreathPart::Expiration;
        from = at;
        i = at;
    }
    std::fill(parts.begin() + std::ptrdiff_t(from), parts.end(), now);
    markOpenTube(waveform, parts);
    return parts;
}

std::vector<RecordedBreath> breathsOf(const std::vector<BreathPart>& parts)
{
    std::vector<RecordedBreath> breaths;
    if (parts.empty())
        return breaths;
    for (std::size_t from = endOfPart(parts, 0); from < parts.size();) {
        const std::size_t inspired = endOfPart(parts, from);
        if (parts[from] != BreathPart::Inspiration || inspired == parts.size()
            || parts[inspired] != BreathPart::Expiration) {
            from = inspired;
            continue;
        }
        const std::size_t end = endOfPart(parts, inspired);
        const bool isWhole = end == parts.size() || parts[end] != BreathPart::Disconnected;
        if (isWhole && parts[from - 1] != BreathPart::Disconnected)
            breaths.push_back({from, inspired, end});
        from = end;
    }
    return breaths;
}

} // namespace carina
