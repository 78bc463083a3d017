#include "engine/io/files/json_fields.h"

#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"

#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr double kKilometreInMillimetres = 1e6;
constexpr double kMostCounted = 1e6;

/// Numbers of a JSON array of exactly that many; nothing where it is none, or one is out of range.
std::optional<std::vector<double>> numbersOf(const QJsonValue& value, qsizetype count)
{
    const QJsonArray array = value.toArray();
    std::vector<double> numbers;
    for (const QJsonValue number : array)
        if (number.isDouble() && std::abs(number.toDouble()) < kKilometreInMillimetres)
            numbers.push_back(number.toDouble());
    if (array.size() != count || numbers.size() != static_cast<std::size_t>(count))
        return std::nullopt;
    return numbers;
}

} // namespace

JsonFields::JsonFields(QJsonObject object, std::optional<Error>& fault, std::string path)
    : m_object{std::move(object)}, m_fault{&fault}, m_path{std::move(path)}
{
}

void JsonFields::allowOnly(std::initializer_list<const char*> keys)
{
    for (const QString& key : m_object.keys()) {
        const bool known = std::ranges::any_of(
            keys, [&key](const char* allowed) { return key == QLatin1StringView{allowed}; });
        if (!known)
            refuse(key.toUtf8().constData(), "this key is not known");
    }
}

bool JsonFields::has(const char* key) const { return m_object.contains(QLatin1StringView{key}); }

std::string JsonFields::text(const char* key)
{
    const QString text = m_object.value(QLatin1StringView{key}).toString();
    if (text.isEmpty())
        refuse(key, "a text is expected");
    return text.toStdString();
}

std::string JsonFields::firstText(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    const QString text = (value.isArray() ? value.toArray().at(0) : value).toString();
    if (text.isEmpty())
        refuse(key, "a text is expected");
    return text.toStdString();
}

double JsonFields::length(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    const double length_mm = value.toDouble();
    if (!value.isDouble() || !(length_mm >= 0.0 && length_mm < kKilometreInMillimetres)) {
        refuse(key, "a length in millimetres is expected");
        return 0.0;
    }
    return millimetres(length_mm).si;
}

std::vector<double> JsonFields::numbers(const char* key, std::size_t count)
{
    const auto numbers = numbersOf(m_object.value(QLatin1StringView{key}), qsizetype(count));
    if (!numbers)
        refuse(key, std::to_string(count) + " numbers are expected");
    return numbers.value_or(std::vector<double>(count, 0.0));
}

double JsonFields::number(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    if (!value.isDouble() || !(std::abs(value.toDouble()) < kMostCounted)) {
        refuse(key, "a number is expected");
        return 0.0;
    }
    return value.toDouble();
}

double JsonFields::amount(const char* key)
{
    const double number = m_object.value(QLatin1StringView{key}).toDouble(-1.0);
    if (!(number >= 0.0 && number <= kMostCounted)) {
        refuse(key, "a number that is not negative is expected");
        return 0.0;
    }
    return number;
}

int JsonFields::count(const char* key)
{
    const double number = m_object.value(QLatin1StringView{key}).toDouble(-1.0);
    if (!(number >= 0.0 && number <= kMostCounted) || number != std::floor(number)) {
        refuse(key, "a whole number is expected");
        return 0;
    }
    return int(number);
}

bool JsonFields::truth(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    if (!value.isBool())
        refuse(key, "true or false is expected");
    return value.toBool();
}

std::size_t JsonFields::oneOf(const char* key, std::span<const char* const> words)
{
    const std::string word = text(key);
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        refuse(key, "\"" + word + "\" is none of its words");
    return found == words.end() ? 0 : std::size_t(found - words.begin());
}

Vec3 JsonFields::point(const char* key)
{
    const auto numbers = numbersOf(m_object.value(QLatin1StringView{key}), 3);
    if (!numbers) {
        refuse(key, "three numbers are expected, in millimetres");
        return Vec3::Zero();
    }
    return millimetres(1.0).si * Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

RigidTransform JsonFields::pose(const char* key)
{
    const QJsonArray rows = m_object.value(QLatin1StringView{key}).toArray();
    Mat4 matrix;
    for (int row = 0; row < 4; ++row) {
        const auto numbers = numbersOf(rows.at(row), 4);
        if (!numbers || rows.size() != 4) {
            refuse(key, "four rows of four numbers are expected");
            return {};
        }
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = (*numbers)[static_cast<std::size_t>(column)];
    }
    matrix.topRightCorner<3, 1>() *= millimetres(1.0).si;
    const Result<RigidTransform> X = RigidTransform::fromMatrix(matrix);
    if (!X)
        refuse(key, X.error().detail);
    return X.value_or(RigidTransform{});
}

JsonFields JsonFields::object(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    if (!value.isObject())
        refuse(key, "an object is expected");
    return {value.toObject(), *m_fault, placeOf(key)};
}

std::vector<JsonFields> JsonFields::objects(const char* key)
{
    const QJsonValue value = m_object.value(QLatin1StringView{key});
    if (!value.isArray())
        refuse(key, "a list is expected");
    std::vector<JsonFields> objects;
    for (const QJsonValue element : value.toArray()) {
        const std::string name = std::string{key} + '[' + std::to_string(objects.size()) + ']';
        if (!element.isObject())
            refuse(name.c_str(), "an object is expected");
        objects.push_back({element.toObject(), *m_fault, placeOf(name)});
    }
    return objects;
}

void JsonFields::refuse(const char* key, const std::string& why)
{
    if (!*m_fault)
        *m_fault = Error{Errc::FileMalformed, placeOf(key) + ": " + why};
}

std::string JsonFields::placeOf(const std::string& key) const
{
    return m_path.empty() ? key : m_path + '.' + key;
}

QJsonArray jsonPoint(const Vec3& p)
{
    return {inMillimetres(metres(p.x())), inMillimetres(metres(p.y())),
            inMillimetres(metres(p.z()))};
}

QJsonArray jsonPose(const RigidTransform& X)
{
    Mat4 matrix = X.matrix();
    matrix.topRightCorner<3, 1>() *= inMillimetres(metres(1.0));
    QJsonArray rows;
    for (int row = 0; row < 4; ++row)
        rows.append(QJsonArray{matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    return rows;
}

Result<QJsonObject> jsonObjectIn(std::string_view text)
{
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(
        QByteArray::fromRawData(text.data(), qsizetype(text.size())), &fault);
    if (fault.error != QJsonParseError::NoError)
        return fail(Errc::FileMalformed, "at byte " + std::to_string(fault.offset) + ": "
                                             + fault.errorString().toStdString());
    return document.object();
}

Result<QJsonObject> readJsonFile(const std::filesystem::path& file, const QString& schema)
{
    const Result<std::string> bytes = readWholeFile(file, kDescriptionLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<QJsonObject> object = jsonObjectIn(*bytes);
    if (!object)
        return fail(object.error().code, file.string() + ": " + object.error().detail);
    const QString found = object->value(QLatin1StringView{"schema"}).toString();
    if (found.isEmpty())
        return fail(Errc::FileMalformed, file.string() + ": schema: a text is expected");
    if (found != schema)
        return fail(Errc::UnknownFormat, file.string() + ": it is " + found.toStdString() + ", and "
                                             + schema.toStdString() + " is expected");
    return object;
}

Result<void> writeJsonFile(const std::filesystem::path& file, const QJsonObject& object)
{
    return writeWholeFile(file, QJsonDocument{object}.toJson().toStdString());
}

} // namespace carina
