#pragma once

#include "models/registration/registration_targets.h"

#include <QTableWidget>

#include <vector>

namespace carina
{

/// What error is expected where: target, RMS, the bound that 95 % stay below, and the direction in
/// which it is largest.
class ErrorTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit ErrorTable(QWidget* parent = nullptr);

    /// Hidden while there is nothing to tell.
    void show(const std::vector<ExpectedError>& errors);

private:
    void explain(int column, const QString& explanation);
};

/// A table to be read: no edges, no editing, whole rows, as high as its rows are.
void makeReadable(QTableView& table);

/// As high as its rows, so that it needs no scroll bar.
void fitHeight(QTableView& table);

} // namespace carina
