#include "apps/lab/command/csv_table.h"

#include "engine/io/files/file_limit.h"

#include <QFile>

namespace carina::lab
{
namespace
{

std::vector<QByteArray> csvFieldsOf(const QByteArray& line)
{
    std::vector<QByteArray> fields;
    for (const QByteArray& field : line.split(','))
        fields.push_back(field.trimmed());
    return fields;
}

} // namespace

Result<CsvTable> CsvTable::read(const QString& file, std::initializer_list<const char*> columns)
{
    const std::string name = file.toStdString();
    QFile source{file};
    if (!source.exists())
        return fail(Errc::FileNotFound, "There is no file " + name + ".");
    if (const auto good = readableSize(name, kMeasurementLimit); !good)
        return tl::unexpected(good.error());
    if (!source.open(QIODevice::ReadOnly))
        return fail(Errc::FileNotFound, name + " cannot be opened.");
    QByteArray bytes = source.readAll();
    if (bytes.startsWith("\xEF\xBB\xBF"))
        bytes.remove(0, 3);
    if (bytes.trimmed().isEmpty())
        return fail(Errc::FileEmpty, name + " is empty.");
    const QList<QByteArray> lines = bytes.split('\n');
    const QList<QByteArray> header = [&] {
        const auto fields = csvFieldsOf(lines.front());
        return QList<QByteArray>{fields.begin(), fields.end()};
    }();
    std::vector<qsizetype> places;
    for (const char* column : columns) {
        places.push_back(header.indexOf(column));
        if (places.back() < 0)
            return fail(Errc::FileMalformed, name + " has no column \"" + column + "\".");
    }
    CsvTable table;
    table.m_file = file;
    for (int line = 1; line < lines.size(); ++line) {
        if (lines[line].trimmed().isEmpty())
            continue;
        const std::vector<QByteArray> fields = csvFieldsOf(lines[line]);
        if (std::ssize(fields) != header.size())
            return fail(Errc::FileMalformed, name + " line " + std::to_string(line + 1) + " has "
                                                 + std::to_string(fields.size()) + " fields, not "
                                                 + std::to_string(header.size()) + ".");
        Row row{.line = line + 1, .fields = {}};
        for (const qsizetype place : places)
            row.fields.push_back(fields[static_cast<std::size_t>(place)]);
        table.m_rows.push_back(std::move(row));
    }
    return table;
}

QString CsvTable::text(std::size_t row, std::size_t column) const
{
    return QString::fromUtf8(m_rows[row].fields[column]);
}

Result<double> CsvTable::number(std::size_t row, std::size_t column) const
{
    bool isNumber = false;
    const double value = m_rows[row].fields[column].toDouble(&isNumber);
    if (!isNumber)
        return fail(Errc::FileMalformed,
                    m_file.toStdString() + " line " + std::to_string(m_rows[row].line) + ": \""
                        + text(row, column).toStdString() + "\" is not a number.");
    return value;
}

} // namespace carina::lab
