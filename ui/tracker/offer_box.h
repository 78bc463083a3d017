#pragma once

#include "models/openigtlink/offer_switch.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace carina
{

/// The switch by which a program gives what it shows to programs of other makers: a button that
/// asks where, and ends it; and where it gives, who can read it, and how many do.
class OfferBox : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 500;

    /// @pre the switch outlives the box.
    explicit OfferBox(OfferSwitch& offer, QWidget* parent = nullptr);

    /// Shows how it is now; a timer calls it every kInterval_ms.
    void refresh();

private:
    void press();

    OfferSwitch& m_offer;
    QPushButton* m_button;
    QLabel* m_text;
};

} // namespace carina
