#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/figures/figure_plots.h"
#include "engine/io/files/whole_file.h"
#include "widgets/report/plot_picture.h"
#include "widgets/report/plot_svg.h"

#include <QJsonArray>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

namespace carina::lab
{
namespace
{

namespace figures_option
{
constexpr Option kFolder{"out", "DIR", "folder to write into; it is created if missing"};
constexpr Option kScenario{"scenario", "NAME|FILE",
                           "the network, as of drift, for all figures but drift-by-delay; paper "
                           "unless given, which has the conditions of the 2004 paper"};
constexpr Option kActions{"actions", "A", "of a run, 8 to 10000; 50 unless given, with --live 12"};
constexpr Option kSeed{"seed", "K", "of the first run, 0 to 4294967295; 1 unless given"};
constexpr Option kSeeds{"seeds", "M",
                        "each number is the mean of so many runs, with the seeds from K on, 1 to "
                        "1000; 20 unless given, with --live always 1"};
constexpr Option kRawAngle{"raw-angle", "",
                           "draws 2 acos(w) for the orientation by action of none, as the paper "
                           "does; where the signs of the two quaternions differ it is above 180 "
                           "degrees for any drift"};
constexpr Option kLive{"live", "", "measures real programs in real time"};
constexpr Option kStrategy{"strategy", "NAME", "only that of drift --live; all unless given"};
constexpr Option kWarmUp{
    "warm-up-s", "T",
    "whole seconds for the clocks to settle before each live run, 0 to 300; 10 unless given"};
} // namespace figures_option

namespace figures_key
{
constexpr Key kSchema{"schema", "carina.figures/1"};
constexpr Key kVersion{"version", "of Carina"};
constexpr Key kScenario{"scenario", "its name"};
constexpr Key kActions{"actions", "as given"};
constexpr Key kSeed{"seed", "as given"};
constexpr Key kSeeds{"seeds", "as given"};
constexpr Key kFigures{"figures", "names of the figures, to which the ending of a file is added"};
constexpr Key kTrends{
    "trends",
    "name of the table of all trends: coefficients from order 0 up, of which that of order 1 is "
    "the slope of a line, and psi_1 to psi_5, what was measured with 2 to 6 participants"};
constexpr Key kPaper{"paper",
                     "name of the table of the values that the 2004 paper prints, beside ours"};
} // namespace figures_key

struct FiguresRequest {
    std::filesystem::path folder;
    FigureSettings settings;
    int seeds = 1;
};

/// Whether the options go together, whatever their values are.
Result<void> checkFigureOptions(const Words& words)
{
    if (words.text(figures_option::kFolder).isEmpty())
        return fail(Errc::WrongOption, "figures: --out DIR is missing.");
    if (words.has(figures_option::kWarmUp) && !words.has(figures_option::kLive))
        return fail(Errc::WrongOption, "figures: --warm-up-s goes with --live.");
    if (words.has(figures_option::kStrategy) && !words.has(figures_option::kLive))
        return fail(Errc::WrongOption, "figures: --strategy goes with --live.");
    return {};
}

Result<std::vector<std::string_view>> strategiesOption(const Words& words)
{
    if (!words.has(figures_option::kStrategy))
        return allStrategies();
    const std::string name = words.text(figures_option::kStrategy).toStdString();
    if (const SyncStrategy* strategy = findSyncStrategy(name))
        return std::vector{strategy->name};
    QStringList names;
    for (const std::string_view known : allStrategies())
        names += QString::fromLatin1(known.data(), qsizetype(known.size()));
    return words.unknownWord(figures_option::kStrategy, names);
}

Result<FiguresRequest> figuresRequest(const Words& words)
{
    if (const auto checked = checkFigureOptions(words); !checked)
        return tl::unexpected(checked.error());
    const bool isLive = words.has(figures_option::kLive);
    const auto actions =
        words.whole(figures_option::kActions, kTrendOfStrategies + 2, 10000, isLive ? 12 : 50);
    const auto seed = words.whole(figures_option::kSeed, 0, 4294967295, 1);
    const auto seeds = words.whole(figures_option::kSeeds, 1, isLive ? 1 : 1000, isLive ? 1 : 20);
    const auto warmUp_s = words.whole(figures_option::kWarmUp, 0, 300, 10);
    for (const auto* number : {&actions, &seed, &seeds, &warmUp_s})
        if (!*number)
            return tl::unexpected(number->error());
    const auto strategies = strategiesOption(words);
    if (!strategies)
        return tl::unexpected(strategies.error());
    FiguresRequest request{words.text(figures_option::kFolder).toStdString(), {}};
    request.settings.actions = static_cast<int>(*actions);
    request.settings.seed = static_cast<std::uint32_t>(*seed);
    request.seeds = static_cast<int>(*seeds);
    request.settings.source = isLive ? liveDrift(*strategies, std::chrono::seconds{*warmUp_s})
                                     : virtualDrift(request.seeds);
    request.settings.isAngleRaw = words.has(figures_option::kRawAngle);
    auto scenario = findScenario(words.has(figures_option::kScenario)
                                     ? words.text(figures_option::kScenario).toStdString()
                                     : "paper");
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
    if (const auto values = besidePaper(figures); !values.empty())
        if (const auto written = write(folder / "paper.csv", paperCsv(values, stamp)); !written)
            return written;
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

Result<QJsonObject> drawnFigures(const Words& words)
{
    auto request = figuresRequest(words);
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
    QJsonObject object{{figures_key::kSchema, QLatin1StringView{figures_key::kSchema.help}},
                       {figures_key::kVersion, QString::fromUtf8(stamp.version)},
                       {figures_key::kScenario, QString::fromStdString(settings.scenario.name)},
                       {figures_key::kActions, settings.actions},
                       {figures_key::kSeed, qint64{settings.seed}},
                       {figures_key::kSeeds, request->seeds},
                       {figures_key::kFigures, names},
                       {figures_key::kTrends, QStringLiteral("trends.csv")}};
    if (!besidePaper(*figures).empty())
        object[figures_key::kPaper] = QStringLiteral("paper.csv");
    return object;
}

Use figuresInVirtualTime()
{
    return {
        .lines = {"--out DIR [OPTION...]"},
        .text = "Draws the drift experiment (see drift) in virtual time: each figure as .svg, .png "
                "and .csv, with the version and the seeds in it, once for the orientation and once "
                "for the position. The same arguments write the same bytes, except in .png, whose "
                "letters depend on the installed fonts. Progress is reported on stderr. The first "
                "five are figures 9 to 13 of the 2004 paper, from runs of our own; the paper does "
                "not have the others.",
        .notes =
            {{"drift-by-action-none", "drift at each action, with a trend of third order"},
             {"drift-by-action-event", "the same, with a trend of sixth order"},
             {"drift-by-action-asa-adaptive", "the same"},
             {"drift-by-participants-event",
              "mean of that drift with 2 to 6 participants, with a linear regression for each of "
              "1, 10, 50 and 100 deg/s and mm/s"},
             {"drift-by-participants-asa-adaptive", "the same"},
             {"drift-by-action-session-clock", "drift at each action, with a trend of sixth order"},
             {"drift-by-participants-session-clock", "as of the other strategies"},
             {"drift-by-delay",
              "time average against the one-way delay, 0.1 to 100 ms, of which 1/21 is a queue, "
              "for all strategies, with the limit of a viewer who goes on with the old motion "
              "until it hears (\"limit until heard\")"}},
        .options = {figures_option::kFolder, figures_option::kScenario, figures_option::kActions,
                    figures_option::kSeed, figures_option::kSeeds, figures_option::kRawAngle},
        .schema = figures_key::kSchema,
        .keys = {figures_key::kVersion, figures_key::kScenario, figures_key::kActions,
                 figures_key::kSeed, figures_key::kSeeds, figures_key::kFigures,
                 figures_key::kTrends, figures_key::kPaper}};
}

Use figuresInRealTime()
{
    return {.lines = {"--out DIR --live [--strategy NAME] [--warm-up-s T] [OPTION...]"},
            .text = "The same from real programs in real time over relays (see drift --live): the "
                    "figures of every strategy, at 100 deg/s and mm/s, of one run of 12 actions "
                    "for each number. These are 16 runs for each strategy, which take 8 minutes, "
                    "and an hour for all. Takes the options above and prints the same keys.",
            .options = {figures_option::kLive, figures_option::kStrategy, figures_option::kWarmUp},
            .schema = figures_key::kSchema};
}

} // namespace

Command figuresCommand()
{
    return {.name = "figures",
            .theme = "drift and network",
            .summary = "draws the drift experiment as figures and tables",
            .uses = {figuresInVirtualTime(), figuresInRealTime()},
            .reminder = "'carina-lab help figures' lists its options.",
            .draws = true,
            .experiment = drawnFigures};
}

} // namespace carina::lab
