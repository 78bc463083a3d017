#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/io/files/whole_file.h"
#include "engine/tracking/time_shift.h"
#include "engine/tracking/tum_file.h"

#include <QFile>

#include <cmath>
#include <optional>

namespace carina::lab
{
namespace
{

namespace lag_option
{
constexpr Option kMost{"most-ms", "MS",
                       "largest shift to either side, 20 to 5000; 500 unless given"};
} // namespace lag_option

namespace lag_key
{
constexpr Key kSchema{"schema", "carina.lag/1"};
constexpr Key kFirst{"first", "FILE as given"};
constexpr Key kSecond{"second", "FILE as given"};
constexpr Key kLag{"lag_ms", "the second stamps the same moment so much later than the first"};
constexpr Key kCorrelation{"correlation", "of the angular speeds at this shift, -1 to 1"};
} // namespace lag_key

/// The samples of a file, at the times that it states: readTumFile counts from the first.
Result<std::vector<PoseSample>> samplesAsStamped(const QString& file,
                                                 std::optional<double>& origin_s)
{
    auto samples = readableSize(file.toStdString(), kMeasurementLimit).and_then([&](std::uint64_t) {
        return readTumFile(file.toStdString());
    });
    if (!samples)
        return samples;
    QFile text{file};
    if (!text.open(QIODevice::ReadOnly))
        return fail(Errc::FileUnreadable, file.toStdString());
    QByteArray line;
    do
        line = text.readLine().simplified(); // words are also apart by tabs
    while (!text.atEnd() && (line.isEmpty() || line.startsWith('#')));
    const double first_s = line.left(line.indexOf(' ')).toDouble();
    if (!origin_s)
        origin_s = first_s;
    for (PoseSample& sample : *samples)
        sample.time += fromSeconds(first_s - *origin_s);
    return samples;
}

Result<QJsonObject> lag(const Words& words)
{
    if (words.files().size() != 2)
        return words.refuse(QStringLiteral("needs two FILEs."));
    const auto most = words.number(lag_option::kMost, 20.0, 5000.0, 500.0);
    if (!most)
        return tl::unexpected(most.error());
    std::optional<double> origin_s;
    const auto first = samplesAsStamped(words.files()[0], origin_s);
    if (!first)
        return tl::unexpected(first.error());
    const auto second = samplesAsStamped(words.files()[1], origin_s);
    if (!second)
        return tl::unexpected(second.error());
    if (std::abs(toSeconds(second->front().time - first->front().time)) > 1e6)
        return words.refuse(QStringLiteral("needs two recordings of one time."));
    const auto shift = timeShift(*first, *second, fromSeconds(1e-3 * *most));
    if (!shift)
        return words.refuse(QStringLiteral("finds no shift: %1.")
                                .arg(QString::fromStdString(shift.error().detail)));
    return QJsonObject{{lag_key::kSchema, QLatin1StringView{lag_key::kSchema.help}},
                       {lag_key::kFirst, words.files()[0]},
                       {lag_key::kSecond, words.files()[1]},
                       {lag_key::kLag, 1e3 * toSeconds(shift->late)},
                       {lag_key::kCorrelation, shift->correlation}};
}

} // namespace

Command lagCommand()
{
    return {
        .name = "lag",
        .theme = "tracking",
        .summary = "how much later one tracker stamps a motion than another",
        .uses = {{.lines = {"FILE FILE"},
                  .text = "Compares two recordings (TUM text: seconds x y z qx qy qz qw) of one "
                          "body that was turned to and fro by hand, seen by two trackers, and "
                          "prints by how much the clock or the delay of the second differs: the "
                          "maximum of the cross-correlation of the angular speeds, which do not "
                          "depend on frames or on where the probes are on the body.",
                  .options = {lag_option::kMost},
                  .schema = lag_key::kSchema,
                  .keys = {lag_key::kFirst, lag_key::kSecond, lag_key::kLag,
                           lag_key::kCorrelation}}},
        .mostFiles = 2,
        .reminder = "It needs two FILEs.",
        .experiment = lag};
}

} // namespace carina::lab
