#pragma once

#include "models/network/strategy_model.h"

#include <QDialog>

class QComboBox;
class QLabel;

namespace carina
{

class CheckedDoubleSpinBox;
class CheckedSpinBox;

/// Asks a researcher by which strategy the session is to keep acted-on objects alike, and with
/// which parameters.
class StrategyDialog : public QDialog
{
    Q_OBJECT

public:
    explicit StrategyDialog(const StrategyChoice& choice, QWidget* parent = nullptr);

    [[nodiscard]] StrategyChoice choice() const;

private:
    void layOut();
    void fill(const StrategyChoice& choice);
    void refresh();

    QComboBox* m_strategy;
    QLabel* m_sentence;
    CheckedSpinBox* m_delays;
    CheckedDoubleSpinBox* m_start;
    CheckedDoubleSpinBox* m_lowest;
    CheckedDoubleSpinBox* m_highest;
    CheckedSpinBox* m_lag;
};

} // namespace carina
