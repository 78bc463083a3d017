#pragma once

#include "engine/io/site/json_text.h"
#include "engine/io/site/site_json.h"

#include <QDateTime>

namespace carina
{

/// Fields that several objects of a site file have.

[[nodiscard]] inline std::string readTime(JsonFields& fields, const char* key)
{
    std::string time = fields.text(key);
    if (!QDateTime::fromString(QString::fromStdString(time), Qt::ISODate).isValid())
        fields.refuse(key, "a date and time as in ISO 8601 is expected");
    return time;
}

[[nodiscard]] inline std::optional<StaleCause> readStale(JsonFields& fields)
{
    if (!fields.has("stale"))
        return std::nullopt;
    return static_cast<StaleCause>(fields.oneOf("stale", kStaleWords));
}

/// A cause that is none is left out.
inline void insertStale(QJsonObject& object, const std::optional<StaleCause>& stale)
{
    if (stale)
        object.insert(QStringLiteral("stale"),
                      QString::fromLatin1(kStaleWords[static_cast<std::size_t>(*stale)]));
}

[[nodiscard]] inline double jsonLength(double length) { return inMillimetres(metres(length)); }

/// The upper triangle of a covariance, row by row.
template <class Matrix> [[nodiscard]] QJsonArray jsonTriangle(const Matrix& matrix)
{
    QJsonArray numbers;
    for (int row = 0; row < matrix.rows(); ++row)
        for (int column = row; column < matrix.cols(); ++column)
            numbers.append(matrix(row, column) / kCovarianceUnit);
    return numbers;
}

/// A covariance of that many dimensions from its upper triangle; zero where it is not there.
template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, Size> readCovariance(JsonFields& fields, const char* key)
{
    using Matrix = Eigen::Matrix<double, Size, Size>;
    Matrix covariance = Matrix::Zero();
    if (!fields.has(key))
        return covariance;
    const std::vector<double> numbers = fields.numbers(key, Size * (Size + 1) / 2);
    auto next = numbers.begin();
    for (int row = 0; row < Size; ++row)
        for (int column = row; column < Size; ++column)
            covariance(row, column) = covariance(column, row) = kCovarianceUnit * *next++;
    if (!isCovariance(covariance))
        fields.refuse(key, "no error has such a covariance");
    return covariance;
}

} // namespace carina
