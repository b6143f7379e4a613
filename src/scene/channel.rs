//! Channels of colour, each with a light of its own.

/// A channel of colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
pub enum Channel {
    /// Red.
    #[serde(rename = "r")]
    Red,
    /// Green.
    #[serde(rename = "g")]
    Green,
    /// Blue.
    #[serde(rename = "b")]
    Blue,
}

impl Channel {
    /// All channels, in order.
    pub const ALL: [Self; 3] = [Self::Red, Self::Green, Self::Blue];

    /// The letter that stands for the channel: `r`, `g` or `b`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Red => "r",
            Self::Green => "g",
            Self::Blue => "b",
        }
    }
}

/// A value for each channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Channels<T> {
    /// The value for red.
    pub r: T,
    /// The value for green.
    pub g: T,
    /// The value for blue.
    pub b: T,
}

impl<T> Channels<T> {
    /// The values of a function, if it has one for each channel.
    ///
    /// # Errors
    /// The first refusal of the function.
    pub fn try_from_fn<E>(mut value: impl FnMut(Channel) -> Result<T, E>) -> Result<Self, E> {
        Ok(Self {
            r: value(Channel::Red)?,
            g: value(Channel::Green)?,
            b: value(Channel::Blue)?,
        })
    }

    /// The value for a channel.
    #[must_use]
    pub const fn of(&self, channel: Channel) -> &T {
        match channel {
            Channel::Red => &self.r,
            Channel::Green => &self.g,
            Channel::Blue => &self.b,
        }
    }

    /// The three values, in order.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        Channel::ALL.into_iter().map(|channel| self.of(channel))
    }

    /// The image of each value.
    pub fn map<U>(&self, mut image: impl FnMut(&T) -> U) -> Channels<U> {
        Channels {
            r: image(&self.r),
            g: image(&self.g),
            b: image(&self.b),
        }
    }
}

impl<T: Copy + PartialEq> Channels<T> {
    /// One value for all channels.
    #[must_use]
    pub const fn grey(value: T) -> Self {
        Self {
            r: value,
            g: value,
            b: value,
        }
    }

    /// Whether the three values are the same.
    #[must_use]
    pub fn is_grey(&self) -> bool {
        self.r == self.g && self.g == self.b
    }
}

impl Channels<f64> {
    /// The mean of the three; of equal numbers it is each of them.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Channels;
    /// assert_eq!(Channels { r: 1.0, g: 2.0, b: 6.0 }.mean(), 3.0);
    /// assert_eq!(Channels::grey(0.747).mean(), 0.747);
    /// ```
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.r + ((self.g - self.r) + (self.b - self.r)) / 3.0
    }

    /// The largest of the three.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.r.max(self.g).max(self.b)
    }
}
