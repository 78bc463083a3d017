#pragma once

#include "models/registration/registration_targets.h"

#include <QTableWidget>

#include <vector>

namespace carina
{

/// The expected TRE as a table: target, RMS, 95 % bound, and the direction in which it is largest.
class ErrorTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit ErrorTable(QWidget* parent = nullptr);

    /// Hidden if `errors` is empty.
    void show(const std::vector<ExpectedError>& errors);

private:
    void explain(int column, const QString& explanation);
};

/// Makes a table read-only, without grid lines, with selection by row, and with rows as high as
/// their content.
void makeReadable(QTableView& table);

/// Makes a table as high as its rows, so that it needs no scroll bar.
void fitHeight(QTableView& table);

} // namespace carina
