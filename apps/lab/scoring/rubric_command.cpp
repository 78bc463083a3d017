#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/io/scoring/rubric_file.h"

namespace carina::lab
{
namespace
{

namespace rubric_key
{
constexpr Key kSchema{"schema", "carina.rubric/1"};
constexpr Key kName{"name", "of the rubric"};
constexpr Key kSource{"source", "where it is published, or whose it is; may be left out"};
constexpr Key kCriteria{"criteria", "one object for each item, at most 100:"};
constexpr Key kItem{"name", "of the item; without it the metric says it", 1};
constexpr Key kAtMost{"at_most", "limit of the metric, in its unit; 1 is yes", 1};
constexpr Key kAtLeast{"at_least", "likewise; each item has one of both", 1};
constexpr Key kPoints{"points", "within the limit", 1};
constexpr Key kPenalty{"penalty", "points less beyond it; 0 where it is left out", 1};
} // namespace rubric_key

Key metricKey()
{
    static const std::string words = [] {
        std::string all = "one of";
        for (std::size_t i = 0; i < kMetricCount; ++i)
            all += (i > 0 ? ", " : " ") + std::string{entryOf(static_cast<Metric>(i)).word};
        return all;
    }();
    return {"metric", words.c_str(), 1};
}

Result<QJsonObject> chosenRubric(const Words& words)
{
    if (words.files().isEmpty())
        return jsonRubric(publishedRubric());
    return readRubricFile(words.files().front().toStdString()).map(jsonRubric);
}

} // namespace

Command rubricCommand()
{
    using namespace rubric_key;
    return {
        .name = "rubric",
        .theme = "the patient",
        .summary = "prints the rubric of tries at intubating, to be changed, or checks one",
        .uses = {{.lines = {"[FILE]"},
                  .text = "Prints a rubric, as the option --rubric of console and trainee reads "
                          "it: the published one, by which they judge a try without that "
                          "option, or that of FILE, once it was checked.",
                  .notes = {{"rubric > ours.json", "a rubric to begin with"},
                            {"rubric ours.json", "whether it can be read, once it was changed"}},
                  .schema = kSchema,
                  .keys = {kName, kSource, kCriteria, metricKey(), kItem, kAtMost, kAtLeast,
                           kPoints, kPenalty}}},
        .mostFiles = 1,
        .experiment = chosenRubric};
}

} // namespace carina::lab
