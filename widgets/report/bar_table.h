#pragma once

#include "widgets/report/page_flow.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace carina
{

/// A table that is a bar chart as well: each row ends in a bar, and where there is one in a mark
/// that the bar is held against, over an axis which all rows share and which begins at 0.
struct BarTable {
    struct Column {
        QString header{};
        double width_mm = 0.0;
        bool isNumber = false; ///< to the right
    };
    struct Row {
        QStringList cells{}; ///< as many as there are columns
        std::optional<double> bar{};
        std::optional<double> mark{};
    };

    std::vector<Column> columns{};
    QString barLabel{};  ///< what a bar shows
    QString markLabel{}; ///< and a mark
    QString unit{};      ///< of both
    std::vector<Row> rows{};
};

/// Adds it row by row. On every page that it reaches it has its headers and its axis. Without one
/// bar it has no chart.
void addTable(PageFlow& flow, const BarTable& table);

} // namespace carina
