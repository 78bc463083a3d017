#include "apps/lab/figures/figures_command.h"

#include "apps/lab/figures/figure_plots.h"
#include "engine/io/files/whole_file.h"
#include "widgets/report/plot_picture.h"
#include "widgets/report/plot_svg.h"

#include <QCommandLineParser>
#include <QJsonArray>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

namespace carina::lab
{
namespace
{

constexpr std::string_view kFiguresHelp =
    R"(figures --out DIR [--scenario NAME|FILE] [--actions A] [--seed K] [--seeds M] [--raw-angle]
        [--live [--warm-up-s T]]
    The drift experiment (see drift) in virtual time, drawn into DIR, which is made if need be: each
    figure as .svg, .png and .csv, with the version and the seeds in it. The same words write the
    same bytes, but for .png, whose letters are of the fonts there are. What is being measured goes
    to stderr. Those of the 2004 paper (its figures 9 to 13), orientation and position, from runs of
    our own:
      drift-by-action-none              drift at each action, trend of third order
      drift-by-action-event             the same, trend of sixth order
      drift-by-action-asa-adaptive      the same
      drift-by-participants-event, drift-by-participants-asa-adaptive
                                        mean of it with 2 to 6 participants, a linear regression
                                        for each of 1, 10, 50 and 100 deg/s and mm/s
    and what it has not:
      drift-by-action-session-clock, drift-by-participants-session-clock
      drift-by-delay                    time average against the one-way delay, 0.1 to 100 ms, of
                                        which 1/21 is a queue; all strategies, the physical limit
    Delays here are the network's alone, so the paper's angles are not to be expected.
    --scenario    as of drift, for all but drift-by-delay; metro, which loses nothing, so that no
                  trend is made by a few lost actions
    --actions A   of a run; 8 to 10000; 50
    --seed K      0 to 4294967295; 1
    --seeds M     each number is the mean of so many runs, from seed K on; 1 to 1000; 20
    --live        from real programs in real time over relays (see drift --live): those figures that
                  are of session-clock, at 100 deg/s and mm/s, of one run of 12 actions for each
                  number; 16 runs, 8 minutes
    --warm-up-s T of the clocks before each live run; 0 to 300; 10
    --raw-angle   in orientation by action 2 acos(w), which exceeds 180 deg, as the paper has it
    schema        "carina.figures/1"
    version, scenario, actions, seed, seeds: of Carina, and as given
    figures       names of the figures, to which the file's ending is added
    trends        the table of all trends: coefficients from order 0 up, for lines 1 is the slope,
                  and psi_1 to psi_5, what was measured with 2 to 6 participants
)";

struct FiguresRequest {
    std::filesystem::path folder;
    FigureSettings settings;
    int seeds = 1;
};

/// A whole number given for an option.
Result<std::int64_t> wholeOf(const QCommandLineParser& parser, const char* name,
                             std::int64_t lowest, std::int64_t highest, std::int64_t otherwise)
{
    const QString text = parser.value(QString::fromLatin1(name));
    if (!parser.isSet(QString::fromLatin1(name)))
        return otherwise;
    bool isNumber = false;
    const qlonglong value = text.toLongLong(&isNumber);
    if (isNumber && value >= lowest && value <= highest)
        return value;
    return fail(Errc::OutOfRange,
                QStringLiteral("figures: --%1 needs a whole number from %2 to %3.")
                    .arg(QString::fromLatin1(name))
                    .arg(lowest)
                    .arg(highest)
                    .toStdString());
}

void addOptions(QCommandLineParser& parser)
{
    for (const auto& [name, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"out", ""},
                                                                    {"scenario", "metro"},
                                                                    {"actions", ""},
                                                                    {"seed", "1"},
                                                                    {"seeds", ""},
                                                                    {"warm-up-s", "10"}})
        parser.addOption(QCommandLineOption{
            QString::fromLatin1(name), {}, QString::fromLatin1(name), QString::fromLatin1(value)});
    for (const char* flag : {"raw-angle", "live"})
        parser.addOption(QCommandLineOption{QString::fromLatin1(flag)});
}

tl::unexpected<Error> notUnderstood(const QString& reason)
{
    return fail(Errc::OutOfRange,
                "figures: " + reason.toStdString() + " 'carina-lab help' lists its options.");
}

Result<FiguresRequest> requestOf(const QStringList& arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(QStringList{QStringLiteral("figures")} + arguments))
        return notUnderstood(parser.errorText());
    if (const QStringList words = parser.positionalArguments(); !words.isEmpty())
        return notUnderstood(QStringLiteral("'%1' is no option.").arg(words.front()));
    const std::string folder = parser.value(QStringLiteral("out")).toStdString();
    if (folder.empty())
        return fail(Errc::OutOfRange, "figures: --out DIR is missing.");
    FiguresRequest request{folder, {}};
    const bool isLive = parser.isSet(QStringLiteral("live"));
    if (!isLive && parser.isSet(QStringLiteral("warm-up-s")))
        return notUnderstood(QStringLiteral("--warm-up-s goes with --live."));
    const auto actions =
        wholeOf(parser, "actions", kTrendOfStrategies + 2, 10000, isLive ? 12 : 50);
    const auto seed = wholeOf(parser, "seed", 0, 4294967295, 1);
    const auto seeds = wholeOf(parser, "seeds", 1, isLive ? 1 : 1000, isLive ? 1 : 20);
    const auto warmUp_s = wholeOf(parser, "warm-up-s", 0, 300, 10);
    for (const auto* number : {&actions, &seed, &seeds, &warmUp_s})
        if (!*number)
            return tl::unexpected(number->error());
    request.settings.actions = static_cast<int>(*actions);
    request.settings.seed = static_cast<std::uint32_t>(*seed);
    request.seeds = static_cast<int>(*seeds);
    request.settings.source =
        isLive ? liveDrift(std::chrono::seconds{*warmUp_s}) : virtualDrift(request.seeds);
    request.settings.isAngleRaw = parser.isSet(QStringLiteral("raw-angle"));
    auto scenario = findScenario(parser.value(QStringLiteral("scenario")).toStdString());
    if (!scenario)
        return tl::unexpected(scenario.error());
    request.settings.scenario = *std::move(scenario);
    return request;
}

Result<std::vector<DriftFigure>> measureFigures(const FigureSettings& settings)
{
    auto figures = figuresByAction(settings);
    if (!figures)
        return figures;
    auto byParticipants = figuresByParticipants(settings);
    if (!byParticipants)
        return byParticipants;
    auto byDelay = figuresByDelay(settings);
    if (!byDelay)
        return byDelay;
    std::ranges::move(*byParticipants, std::back_inserter(*figures));
    std::ranges::move(*byDelay, std::back_inserter(*figures));
    return figures;
}

Result<void> write(const std::filesystem::path& file, const QByteArray& bytes)
{
    const auto written = writeWholeFile(file, {bytes.data(), std::size_t(bytes.size())});
    if (!written)
        return fail(written.error().code, "figures: " + written.error().detail + '.');
    return {};
}

Result<void> writeAll(const std::filesystem::path& folder, const std::vector<DriftFigure>& figures,
                      const FigureStamp& stamp)
{
    for (const DriftFigure& figure : figures) {
        const Plot plot = plotOf(figure, stamp);
        const QByteArray svg = svgOf(plot);
        auto written = write(folder / (figure.name + ".csv"), pointsCsv(figure, stamp));
        if (written)
            written = write(folder / (figure.name + ".svg"), svg);
        if (written)
            written = write(folder / (figure.name + ".png"), pngOf(svg, plot.stamp));
        if (!written)
            return written;
    }
    return write(folder / "trends.csv", trendsCsv(figures, stamp));
}

/// Says on stderr which curve of how many is being measured.
void announceCurves(FigureSettings& settings)
{
    settings.onCurve = [curve = std::size_t{0}, curves = curvesToMeasure(settings.source)](
                           const std::string& name) mutable {
        ++curve;
        std::fprintf(stderr, "figures: %zu of %zu: %s\n", curve, curves, name.c_str());
    };
}

Result<QJsonObject> runFiguresCommand(const QStringList& arguments)
{
    auto request = requestOf(arguments);
    if (!request)
        return tl::unexpected(request.error());
    if (const auto opened = openFolder(request->folder); !opened)
        return fail(opened.error().code, "figures: " + opened.error().detail + '.');
    FigureSettings& settings = request->settings;
    announceCurves(settings);
    const auto figures = measureFigures(settings);
    if (!figures)
        return tl::unexpected(figures.error());
    const FigureStamp stamp{CARINA_VERSION, settings.seed, request->seeds};
    if (const auto written = writeAll(request->folder, *figures, stamp); !written)
        return tl::unexpected(written.error());
    QJsonArray names;
    for (const DriftFigure& figure : *figures)
        names.append(QString::fromStdString(figure.name));
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.figures/1")},
                       {QStringLiteral("version"), QString::fromUtf8(stamp.version)},
                       {QStringLiteral("scenario"), QString::fromStdString(settings.scenario.name)},
                       {QStringLiteral("actions"), settings.actions},
                       {QStringLiteral("seed"), qint64{settings.seed}},
                       {QStringLiteral("seeds"), request->seeds},
                       {QStringLiteral("figures"), names},
                       {QStringLiteral("trends"), QStringLiteral("trends.csv")}};
}

} // namespace

Command figuresCommand() { return {"figures", kFiguresHelp, runFiguresCommand}; }

} // namespace carina::lab
