#include "engine/io/scoring/rubric_file.h"

#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"

#include <QJsonArray>

namespace carina
{
namespace
{

const QString kRubricSchema = QStringLiteral("carina.rubric/1");

std::string optionalText(JsonFields& fields, const char* key)
{
    return fields.has(key) ? fields.text(key) : std::string{};
}

Metric readMetric(JsonFields& fields)
{
    const std::string word = fields.text("metric");
    const std::optional<Metric> metric = metricOf(word);
    if (!metric)
        fields.refuse("metric", "\"" + word + "\" is none of its words");
    return metric.value_or(Metric{});
}

Criterion readCriterion(JsonFields& fields)
{
    fields.allowOnly({"name", "metric", "at_most", "at_least", "points", "penalty"});
    Criterion criterion{.name = optionalText(fields, "name"), .metric = readMetric(fields)};
    const bool isAtMost = fields.has("at_most");
    if (isAtMost == fields.has("at_least"))
        fields.refuse("metric", "either at_most or at_least is expected");
    criterion.bound = isAtMost ? Bound::AtMost : Bound::AtLeast;
    criterion.limit = fields.number(isAtMost ? "at_most" : "at_least");
    criterion.points = fields.amount("points");
    criterion.penalty = fields.has("penalty") ? fields.amount("penalty") : 0.0;
    return criterion;
}

Rubric readRubric(JsonFields& fields)
{
    fields.allowOnly({"schema", "name", "source", "criteria"});
    Rubric rubric{.name = fields.text("name"), .source = optionalText(fields, "source")};
    for (JsonFields& criterion : fields.objects("criteria"))
        rubric.criteria.push_back(readCriterion(criterion));
    if (rubric.criteria.empty() || rubric.criteria.size() > kMostCriteria)
        fields.refuse("criteria", "1 to " + std::to_string(kMostCriteria) + " are expected");
    return rubric;
}

Result<Rubric> rubricOf(const QJsonObject& object)
{
    std::optional<Error> fault;
    JsonFields fields{object, fault};
    Rubric rubric = readRubric(fields);
    if (fault)
        return tl::unexpected(*fault);
    return rubric;
}

QJsonObject jsonCriterion(const Criterion& criterion)
{
    QJsonObject object{
        {QStringLiteral("metric"), QString::fromLatin1(entryOf(criterion.metric).word)},
        {criterion.bound == Bound::AtMost ? QStringLiteral("at_most") : QStringLiteral("at_least"),
         criterion.limit},
        {QStringLiteral("points"), criterion.points}};
    if (!criterion.name.empty())
        object.insert(QStringLiteral("name"), QString::fromStdString(criterion.name));
    if (criterion.penalty > 0.0)
        object.insert(QStringLiteral("penalty"), criterion.penalty);
    return object;
}

} // namespace

Result<Rubric> rubricIn(std::string_view text)
{
    const Result<QJsonObject> object = jsonObjectIn(text);
    if (!object)
        return tl::unexpected(object.error());
    const QString schema = object->value(QStringLiteral("schema")).toString();
    if (schema.isEmpty())
        return fail(Errc::FileMalformed, "schema: a text is expected");
    if (schema != kRubricSchema)
        return fail(Errc::UnknownFormat, "it is " + schema.toStdString() + ", and "
                                             + kRubricSchema.toStdString() + " is expected");
    return rubricOf(*object);
}

QJsonObject jsonRubric(const Rubric& rubric)
{
    QJsonArray criteria;
    for (const Criterion& criterion : rubric.criteria)
        criteria.append(jsonCriterion(criterion));
    QJsonObject object{{QStringLiteral("schema"), kRubricSchema},
                       {QStringLiteral("name"), QString::fromStdString(rubric.name)},
                       {QStringLiteral("criteria"), criteria}};
    if (!rubric.source.empty())
        object.insert(QStringLiteral("source"), QString::fromStdString(rubric.source));
    return object;
}

Result<Rubric> readRubricFile(const std::filesystem::path& file)
{
    const Result<std::string> bytes = readWholeFile(file, kDescriptionLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    Result<Rubric> rubric = rubricIn(*bytes);
    if (!rubric)
        return fail(rubric.error().code, file.string() + ": " + rubric.error().detail);
    return rubric;
}

} // namespace carina
