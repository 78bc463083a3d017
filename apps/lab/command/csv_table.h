#pragma once

#include "engine/core/result.h"

#include <QByteArray>
#include <QString>

#include <initializer_list>
#include <vector>

namespace carina::lab
{

/// Some columns of a CSV file: a line of names, then a line for each row, fields parted by commas.
class CsvTable
{
public:
    /// Reads the columns asked for, in any order in the file; others are passed over, and so are
    /// empty lines.
    /// @returns FileNotFound; FileEmpty; FileMalformed where a column is missing or a row has
    ///          another number of fields than the first line. The detail is a sentence that names
    ///          the file, and the line.
    [[nodiscard]] static Result<CsvTable> read(const QString& file,
                                               std::initializer_list<const char*> columns);

    [[nodiscard]] std::size_t rows() const { return m_rows.size(); }
    /// A field of a column by its place in what was asked for.
    [[nodiscard]] QString text(std::size_t row, std::size_t column) const;
    /// The same as a number; NaN and infinities are numbers here.
    /// @returns FileMalformed where it is none.
    [[nodiscard]] Result<double> number(std::size_t row, std::size_t column) const;

private:
    struct Row {
        int line = 0;
        std::vector<QByteArray> fields;
    };

    QString m_file;
    std::vector<Row> m_rows;
};

} // namespace carina::lab
