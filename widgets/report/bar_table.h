#pragma once

#include "widgets/report/page_flow.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace carina
{

/// A table with a bar chart: each row ends with a bar and, if given, a mark to compare it with, on
/// an axis that starts at 0 and is common to all rows.
struct BarTable {
    struct Column {
        QString header{};
        double width_mm = 0.0;
        bool isNumber = false; ///< aligned right
    };
    struct Row {
        QStringList cells{}; ///< one per column
        std::optional<double> bar{};
        std::optional<double> mark{};
    };

    std::vector<Column> columns{};
    QString barLabel{};  ///< the quantity of the bars
    QString markLabel{}; ///< the quantity of the marks
    QString unit{};      ///< of both
    std::vector<Row> rows{};
};

/// Adds the table row by row. Headers and axis are repeated on each page. A table without any bar
/// has no chart.
void addTable(PageFlow& flow, const BarTable& table);

} // namespace carina
