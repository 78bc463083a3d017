#pragma once

#include "models/openigtlink/offer_switch.h"

#include <QDialog>

class QCheckBox;
class QLabel;

namespace carina
{

class CheckedSpinBox;
class MessageLine;

/// Asks where a program is to give what it shows to programs of other makers, and says who can read
/// it there: only this computer's, unless a person opens it to others.
class OfferDialog : public QDialog
{
    Q_OBJECT

public:
    /// @pre the switch outlives the dialog.
    explicit OfferDialog(OfferSwitch& offer, QWidget* parent = nullptr);

    /// Begins to give, if that is possible; else says why not.
    void accept() override;

private:
    void layOut();
    [[nodiscard]] IgtlPlace place() const;
    void refresh();

    OfferSwitch& m_offer;
    CheckedSpinBox* m_port;
    QCheckBox* m_isOpen;
    QLabel* m_warning;
    MessageLine* m_problem;
};

} // namespace carina
