#include "apps/lab/registration/landmark_table.h"

#include "apps/lab/command/csv_table.h"

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

/// The numbers of a row from a column on.
template <int Count>
Result<Eigen::Matrix<double, Count, 1>> numbersOf(const CsvTable& table, std::size_t row,
                                                  std::size_t column)
{
    Eigen::Matrix<double, Count, 1> numbers;
    for (int i = 0; i < Count; ++i) {
        const Result<double> number = table.number(row, column + static_cast<std::size_t>(i));
        if (!number)
            return tl::unexpected(number.error());
        numbers[i] = *number;
    }
    return numbers;
}

/// A landmark that stands there twice counts for two where it tells as much as one.
Result<void> checkNames(const QString& file, std::vector<std::string> names)
{
    std::ranges::sort(names);
    const auto twice = std::ranges::adjacent_find(names);
    if (twice == names.end())
        return {};
    return fail(Errc::FileMalformed,
                file.toStdString() + " names the landmark " + *twice + " twice; leave one out.");
}

/// From xx, yy, zz, xy, xz, yz in mm^2.
Mat3 covarianceOf(const Eigen::Matrix<double, 6, 1>& c)
{
    Mat3 covariance;
    covariance << c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2];
    return std::pow(millimetres(1.0).si, 2) * covariance;
}

Result<Mat3> covarianceOf(const CsvTable& table, std::size_t row, std::size_t column)
{
    const auto numbers = numbersOf<6>(table, row, column);
    if (!numbers)
        return tl::unexpected(numbers.error());
    return covarianceOf(*numbers);
}

} // namespace

std::vector<LandmarkPair> NamedPairs::unweighted() const
{
    std::vector<LandmarkPair> only;
    for (const UncertainPair& pair : pairs)
        only.push_back(pair.pair);
    return only;
}

Result<NamedPlaces> readPlaces(const QString& file, bool withCovariances)
{
    const auto table = withCovariances ? CsvTable::read(file, {"name", "ax", "ay", "az", "cxx",
                                                               "cyy", "czz", "cxy", "cxz", "cyz"})
                                       : CsvTable::read(file, {"name", "ax", "ay", "az"});
    if (!table)
        return tl::unexpected(table.error());
    NamedPlaces named;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        const auto p_mm = numbersOf<3>(*table, row, 1);
        if (!p_mm)
            return tl::unexpected(p_mm.error());
        const Result<Mat3> covariance =
            withCovariances ? covarianceOf(*table, row, 4) : Result<Mat3>{Mat3::Zero()};
        if (!covariance)
            return tl::unexpected(covariance.error());
        named.names.push_back(table->text(row, 0).toStdString());
        named.places.push_back({millimetres(1.0).si * *p_mm, *covariance});
    }
    return named;
}

Result<NamedPairs> readPairs(const QString& file, bool withCovariances)
{
    const Result<NamedPlaces> known = readPlaces(file, withCovariances);
    if (!known)
        return tl::unexpected(known.error());
    if (const auto distinct = checkNames(file, known->names); !distinct)
        return tl::unexpected(distinct.error());
    const auto table = CsvTable::read(file, {"mx", "my", "mz"});
    if (!table)
        return tl::unexpected(table.error());
    NamedPairs named{known->names, {}};
    for (std::size_t row = 0; row < table->rows(); ++row) {
        const auto p_mm = numbersOf<3>(*table, row, 0);
        if (!p_mm)
            return tl::unexpected(p_mm.error());
        named.pairs.push_back({.pair = {known->places[row].p_AQ, millimetres(1.0).si * *p_mm},
                               .covariance_A = known->places[row].covariance_A});
    }
    return named;
}

Result<Length> positiveMillimetres(const Words& words, const Option& option, Length otherwise)
{
    if (!words.has(option))
        return otherwise;
    bool isNumber = false;
    const double mm = words.text(option).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(mm) || mm <= 0.0)
        return fail(Errc::WrongOption,
                    "--" + std::string{option.name} + " needs a number of millimetres above 0.");
    return millimetres(mm);
}

} // namespace carina::lab
